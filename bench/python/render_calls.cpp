/// Prints, for so many calls of Renderer::render(), the milliseconds that each takes beside the frame's stages: for
/// bench/python/measure, which does the same from Python. Usage: aeolic_render_calls CALLS

#include <aeolic/aeolic.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
    aeolic::SceneDescription scene;
    scene.surface.spec = "teapot";
    scene.field.spec = "abc:32,32,32";
    scene.lic.steps = 16;
    scene.run.backend = aeolic::BackendChoice::cpu;
    aeolic::Renderer renderer(scene);
    scene.camera.azimuth = 30;
    for (int call = 0; call < (argc > 1 ? std::atoi(argv[1]) : 100); ++call) {
        const auto start = std::chrono::steady_clock::now();
        const aeolic::Picture picture = renderer.render({scene.camera});
        const std::chrono::duration<double, std::milli> whole = std::chrono::steady_clock::now() - start;
        std::printf("%.4f\n", whole.count() - renderer.lastFrame().totalMs);
    }
}
