using BenchmarkDotNet.Running;
using RayTracer.Benchmarks;
using RayTracer.Benchmarks.Denoising;
using RayTracer.Benchmarks.Embree;
using RayTracer.Benchmarks.Mitsuba;
using RayTracer.Benchmarks.Precision;
using RayTracer.Benchmarks.Standing;
using RayTracer.Benchmarks.Studio;
using RayTracer.Jobs;

// "scenes FOLDER" writes the scenes that builds are compared on; "ratios [SCENE…]" compares whole renders in one run, "embree" the triangle
// tree with Embree, "mitsuba SCENE.xml SAMPLES…" whole renders with Mitsuba, "mitsuba cloud SAMPLES" those of a cloud; "studio [SCENE]" measures how quickly the Studio follows a hand, "studio moving" what is seen meanwhile;
// "images FILE…" compares reading PNG and JPEG files with the common libraries' own commands; "denoiser [SCENE…]" measures what the denoiser
// gains on scenes that are hard for it, "precision" what single precision gains over double, and loses, "lights" what the choice of one light of many
// gains; anything else goes to BenchmarkDotNet ("--filter *").
if (args is ["ratios" or "mitsuba" or "studio", ..])
{
    // As wide as the programs themselves render.
    WideVectors.Enable(args);
}

switch (args)
{
    case ["scenes", var folder]:
        StandingScenes.Write(folder);
        return 0;
    case ["ratios", .. var scenes]:
        return Ratios.Run(scenes);
    case ["embree", .. var options]:
        return EmbreeBenchmark.Run(options);
    case ["mitsuba", .. var scenes]:
        return MitsubaBenchmark.Run(scenes);
    case ["studio", "moving", .. var options]:
        return new MovingQuality(options).Run();
    case ["studio", .. var options]:
        return await StudioBenchmark.Run(options);
    case ["denoiser", .. var scenes]:
        return DenoiserBenchmark.Run(scenes);
    case ["lights"]:
        return LightChoice.Run();
    case ["precision"]:
        return PrecisionBenchmark.Run();
    case ["images", .. var files]:
        return ImageBenchmark.Run(files);
    default:
        BenchmarkSwitcher.FromAssembly(typeof(Ratios).Assembly).Run(args);
        return 0;
}
