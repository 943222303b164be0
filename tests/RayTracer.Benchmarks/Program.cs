using BenchmarkDotNet.Running;
using RayTracer.Benchmarks;
using RayTracer.Benchmarks.Denoising;
using RayTracer.Benchmarks.Embree;
using RayTracer.Benchmarks.Mitsuba;
using RayTracer.Benchmarks.Studio;

// "ratios [SCENE…]" compares whole renders in one run, "embree" the triangle tree with Embree, "mitsuba SCENE.xml SAMPLES…" whole renders with
// Mitsuba; "studio [SCENE]" measures how quickly the Studio follows a hand; "images FILE…" compares reading
// PNG and JPEG files with the common libraries' own commands; "denoiser [SCENE…]" measures what the denoiser gains on scenes that are hard for it; anything else goes to
// BenchmarkDotNet ("--filter *").
if (args.Length > 0 && args[0] == "ratios")
{
    return Ratios.Run(args[1..]);
}

if (args.Length > 0 && args[0] == "embree")
{
    return EmbreeBenchmark.Run(args[1..]);
}

if (args.Length > 0 && args[0] == "mitsuba")
{
    return MitsubaBenchmark.Run(args[1..]);
}

if (args.Length > 0 && args[0] == "studio")
{
    return await StudioBenchmark.Run(args[1..]);
}

if (args.Length > 0 && args[0] == "denoiser")
{
    return DenoiserBenchmark.Run(args[1..]);
}

if (args.Length > 0 && args[0] == "images")
{
    return ImageBenchmark.Run(args[1..]);
}

BenchmarkSwitcher.FromAssembly(typeof(Ratios).Assembly).Run(args);
return 0;
