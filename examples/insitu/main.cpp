// A solver that draws what it computes while it computes: without files between them, on the ranks that it has.
//   mpirun -n 2 insitu --steps 4000 --every 40 -o street-%04d.png
//   mpirun -n 2 insitu --steps 100000 --every 5 --serve
#include <aeolic/aeolic.h>
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>

#include "lattice.h"
#include "sheets.h"

namespace {

using namespace std::chrono_literals;

struct Options {
    Lattice::Options lattice;
    int steps = 2000, every = 20;
    std::string pictures, files;  // Names of pictures, with %d for the step; a folder.
    bool serve = false;
};

Options optionsFrom(int count, char** words)
{
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--serve") {
            options.serve = true;
            continue;
        }
        if (i + 1 == count) throw std::invalid_argument(word + ": unknown, or its value is missing");
        const char* value = words[++i];
        auto& size = options.lattice.size;
        bool fine = true;
        if (word == "--steps")
            fine = std::sscanf(value, "%d", &options.steps) == 1 && options.steps > 0;
        else if (word == "--every")
            fine = std::sscanf(value, "%d", &options.every) == 1 && options.every > 0;
        else if (word == "--size")
            fine = std::sscanf(value, "%dx%dx%d", &size[0], &size[1], &size[2]) == 3 && size[0] >= 4 && size[1] >= 16 &&
                   size[2] >= 16 && std::max({size[0], size[1], size[2]}) <= 2048;
        else if (word == "-o")
            options.pictures = value;
        else if (word == "--files")
            options.files = value;
        else
            throw std::invalid_argument(word +
                                        ": unknown; expected --size XxYxZ, --steps, --every, -o, --files or --serve");
        if (!fine) throw std::invalid_argument(word + ": found '" + value + "'");
    }
    return options;
}

aeolic::SceneDescription sceneOf(const Options& options)
{
    aeolic::SceneDescription scene;
    scene.field.vectors = "velocity";
    scene.shading.colorBy = "velocity:mag";
    scene.shading.colorRange = {{0, 1.6 * double(options.lattice.inflow)}};
    scene.output.width = 1200;
    scene.output.height = 500;
    scene.camera.azimuth = 60;
    scene.camera.elevation = 20;
    scene.camera.roll = 90;  // The flow goes from left to right.
    scene.camera.zoom = 1.9;
    return scene;
}

std::string nameOf(const std::string& pattern, int step)
{
    char name[4096];
    std::snprintf(name, sizeof name, pattern.c_str(), step);
    return name;
}

void run(const Options& options)
{
    const MPI_Comm all = MPI_COMM_WORLD;
    int rank = 0;
    MPI_Comm_rank(all, &rank);
    Lattice lattice(options.lattice, all);
    Sheets sheets(lattice, all);
    const aeolic::SceneDescription scene = sceneOf(options);
    aeolic::Renderer renderer(scene, sheets.data(), aeolic::joinRanks(&all));

    std::optional<aeolic::Live> live;
    if (options.serve) {
        aeolic::LiveOptions shown;
        shown.title = "Solver";
        using Kind = aeolic::Control::Kind;
        shown.controls = {{"pause", Kind::toggle, 0, 0, 1, ""},
                          {"step", Kind::button, 0, 0, 1, ""},
                          {"inflow", Kind::number, options.lattice.inflow, 0.02, 0.12, "cells/step"}};
        live.emplace(renderer, shown);
        if (rank == 0) std::printf("%s\n", live->address().c_str());
        std::fflush(stdout);
    }

    double drawn = 0, stepsTaken = 0;
    const double begin = MPI_Wtime();
    for (int step = 1; step <= options.steps; ++step) {
        lattice.step();
        const bool one = live && stepsTaken != live->value("step");  // Somebody wants to see a single one.
        if (step % options.every != 0 && !one) continue;
        const double before = MPI_Wtime();
        sheets.update(lattice);
        renderer.setData(sheets.data());
        if (!options.pictures.empty()) {
            const aeolic::Picture picture = renderer.render();
            if (rank == 0) aeolic::writePicture(picture, nameOf(options.pictures, step));
        }
        if (!options.files.empty()) sheets.write(options.files, nameOf("step-%d", step));
        if (live) {
            live->serve(renderer);
            stepsTaken = live->value("step");
            while (live->value("pause") == 1 && stepsTaken == live->value("step")) live->serve(renderer, 50ms);
            lattice.setInflow(float(live->value("inflow")));
        }
        drawn += MPI_Wtime() - before;
    }
    const double whole = MPI_Wtime() - begin;
    if (rank == 0)
        std::printf("%d steps in %.1f s, of which %.1f %% went into %d pictures\n", options.steps, whole,
                    100 * drawn / whole, options.steps / options.every);
}

}  // namespace

int main(int count, char** words)
{
    int threads = 0;
    MPI_Init_thread(&count, &words, MPI_THREAD_SERIALIZED, &threads);
    try {
        run(optionsFrom(count, words));
    } catch (const std::exception& error) {
        int rank = 0;
        MPI_Comm_rank(MPI_COMM_WORLD, &rank);
        if (rank == 0) std::fprintf(stderr, "insitu: %s\n", error.what());
        MPI_Abort(MPI_COMM_WORLD, 2);
    }
    MPI_Finalize();
}
