using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Shapes;

namespace RayTracer.Tests.Acceleration;

/// <summary>Covers `InstanceTable` and `InstanceTree`.</summary>
[Collection(MeasuredMemory.Name)]
public class InstanceMemoryTests
{
    private const int Many = 10_000;

    [Fact]
    public void An_instance_costs_no_more_than_256_bytes()
    {
        // What is only needed once is there before anything is measured. The runtime takes and gives back memory meanwhile, too: the middle of some rounds counts.
        Build(2);
        long[] rounds = [.. Enumerable.Range(0, 7).Select(_ => Build(Many + 1).Bytes - Build(1).Bytes).Order()];
        Scene one = Make(1);
        Scene many = Make(Many + 1);
        Assert.Equal(one.World.Count, many.World.Count);

        // Of the tree over the instances, which is not in the managed heap, too.
        long all = rounds[3] + many.World.Instances!.TreeBytes - one.World.Instances!.TreeBytes;
        Assert.InRange((double)all / Many, 96, 256);
        Assert.InRange((double)(many.World.Instances.MemoryBytes - one.World.Instances.MemoryBytes) / Many, 96, 256);
    }

    [Fact]
    public void Instances_of_instances_are_all_there()
    {
        InstanceDescription row = new() { Of = new GroupDescription { Shapes = [.. Enumerable.Range(0, 10).Select(i => At(Mesh(), i, 0))] } };
        SceneDescription description = new() { Shapes = [.. Enumerable.Range(0, 10).Select(i => At(row, 0, i))] };
        SceneBuilder builder = new((_, _) => throw new NotSupportedException());
        Scene scene = builder.Build(description)!;
        Assert.Empty(builder.Complaints);
        Assert.Equal(100, scene.World.Instances!.Count);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static (Scene Scene, long Bytes) Build(int instances)
    {
        long before = GC.GetTotalMemory(forceFullCollection: true);
        Scene scene = Make(instances);
        return (scene, GC.GetTotalMemory(forceFullCollection: true) - before);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Scene Make(int instances)
    {
        MeshDescription mesh = Mesh();
        SceneBuilder builder = new((_, _) => throw new NotSupportedException());
        return builder.Build(new() { Shapes = [.. Enumerable.Range(0, instances).Select(i => At(mesh, i % 100, i / 100))] })!;
    }

    private static InstanceDescription At(ShapeDescription of, float x, float z) => new() { Of = of, Transform = [new() { Translate = new(x, 0, z), Rotate = x }] };

    private static MeshDescription Mesh() => new()
    {
        Positions = [.. Enumerable.Range(0, 102).Select(i => new Vector3(i * 0.01f, i % 2, 0))],
        Triangles = [.. Enumerable.Range(0, 100).Select(i => i % 2 == 0 ? new TriangleIndices(i, i + 2, i + 1) : new(i, i + 1, i + 2))],
    };
}
