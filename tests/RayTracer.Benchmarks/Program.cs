using BenchmarkDotNet.Running;
using RayTracer.Benchmarks;

// "ratios [SCENE…]" compares whole renders in one run; anything else goes to BenchmarkDotNet ("--filter *").
if (args.Length > 0 && args[0] == "ratios")
{
    return Ratios.Run(args[1..]);
}

BenchmarkSwitcher.FromAssembly(typeof(Ratios).Assembly).Run(args);
return 0;
