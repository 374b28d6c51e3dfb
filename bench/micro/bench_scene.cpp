#include "bench_scene.h"
#include "description/choices.h"

#include <map>

#include "common/measuring.h"
#include "data/load/loaded_scene.h"
#include "data/mesh/mesh_tools.h"

namespace aeolic::bench {

std::string sizeName(const Size& size)
{
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

BenchScene::BenchScene(const std::string& backendName)
{
    SceneDescription description;
    description.field.spec = "abc";
    scene = loadScene(description);
    radius_ = radiusAbout(scene.surface, scene.boundsWorld.center());
    backend = makeBackend(*choiceNamed<BackendChoice>(backendName), scene);
}

BenchScene& BenchScene::on(const std::string& backendName)
{
    static std::map<std::string, std::unique_ptr<BenchScene>> scenes;
    auto& made = scenes[backendName];
    if (!made) made.reset(new BenchScene(backendName));
    return *made;
}

View BenchScene::view(const Size& size, const LicOptions& lic) const
{
    CameraOptions camera;
    camera.zoom = kTeapotZoom;
    camera = filling(camera, size.width, size.height);
    return makeView(makeCamera(camera, scene.boundsWorld, radius_, size.width, size.height), scene, lic);
}

LicOptions licOf(LicMethod method, int steps)
{
    LicOptions lic;
    lic.method = method;
    lic.steps = steps;
    return lic;
}

}  // namespace aeolic::bench
