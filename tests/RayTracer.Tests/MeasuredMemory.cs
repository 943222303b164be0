namespace RayTracer.Tests;

/// <summary>Tests that measure the memory of the process: they run by themselves, after all others.</summary>
[CollectionDefinition(Name, DisableParallelization = true)]
public sealed class MeasuredMemory
{
    /// <summary>The collection's name.</summary>
    public const string Name = "measured memory";
}
