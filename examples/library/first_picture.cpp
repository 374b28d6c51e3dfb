#include <aeolic/aeolic.h>

int main()
{
    aeolic::SceneDescription scene;
    scene.surface.spec = "teapot";
    scene.field.spec = "abc";
    aeolic::Renderer renderer(scene);
    aeolic::writePng(renderer.render(), "teapot.png");
}
