// The frame's camera and options: ViewBlock in device/gl_blocks.h.
layout(std140, binding = 0) uniform ViewBlock {
    vec4 eyeAndFocal;       // eyeLocal | focalPx
    vec4 rightAndCenterX;   // right | centerX, pixels
    vec4 upAndCenterY;
    vec4 forwardAndNear;    // forward | nearDepth
    vec4 noiseRow[3];       // Rows of texelFromLocal.
    vec4 clipScale;         // NDC per unit of the eye-space slope (x, y) | NDC of the image's centre (x, y)
    float stepLocal, vectorScale, tinyVector, maxStepPx;
    float flowUnitPx, inverseFocal, levelFromFootprint, maskBelow;
    ivec2 imageSize;        // Whole, pixels.
    int firstRow, rows;     // What the frame's textures hold of the image: the first row, global, and how many.
    bool normalizeSteps;
    float vectorFactor, vectorUnit;  // Between the data's unit of vectors and the kernels'.
    uint grains;  // What the noise's texels stand for: GrainValue (render/lic/noise.h).
    float fadePerVector;
} view;
