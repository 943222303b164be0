using RayTracer.Acceleration;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Rendering;

/// <summary>The numbers of things in a scene, and the memory that they take.</summary>
public sealed class SceneStatistics
{
    private readonly World _world;

    /// <summary>Counts.</summary>
    /// <param name="scene">The scene.</param>
    public SceneStatistics(Scene scene)
    {
        _world = scene.World;
        Trees = [.. FindTrees()];
    }

    /// <summary>Meshes, each counted once however many instances show it.</summary>
    public int Meshes => _world.Spaces.Sum(s => s.Contents.Meshes.Count);

    /// <summary>Triangles of meshes, each counted once.</summary>
    public long Triangles => _world.Spaces.Sum(s => (long)(s.Mesh?.Count ?? 0));

    /// <summary>Triangles of meshes, each counted as often as it stands in the scene.</summary>
    public long TrianglesShown => (_world.Itself.Mesh?.Count ?? 0) + InstanceNumbers.Sum(i => (long)(_world.Instances!.SpaceOf(i).Mesh?.Count ?? 0));

    /// <summary>Instances, those that were made of moving or sheared shapes included.</summary>
    public int Instances => _world.Instances?.Count ?? 0;

    /// <summary>Memory of the shapes other than meshes, and of the trees over them.</summary>
    public long ShapeBytes => _world.Spaces.Sum(s => s.Batches.Sum(b => b.MemoryBytes) + s.Primitives.TreeBytes);

    /// <summary>
    /// Memory of the meshes: corners, indices and what corners carry, and the copy of the triangles in the trees' leaves.
    /// </summary>
    public long TriangleBytes => _world.Spaces.Sum(s => s.Mesh?.MemoryBytes ?? 0) + Trees.Where(t => t.Holds != HoldsInstances).Sum(t => t.LeafBytes);

    /// <summary>Memory of the nodes of all trees.</summary>
    public long NodeBytes => Trees.Sum(t => t.NodeBytes);

    /// <summary>Memory of the instances, without the nodes over them.</summary>
    public long InstanceBytes => (_world.Instances?.MemoryBytes ?? 0) - Trees.Where(t => t.Holds == HoldsInstances).Sum(t => t.NodeBytes);

    /// <summary>The trees: of the world's own triangles, of those of each object, and of the instances.</summary>
    public IReadOnlyList<SceneTree> Trees { get; }

    /// <summary>The box around all that is finite; infinite where nothing is.</summary>
    public Bounds FiniteBounds
    {
        get
        {
            Bounds all = Finite(_world.Itself);
            foreach (int i in InstanceNumbers)
            {
                Bounds box = Finite(_world.Instances!.SpaceOf(i)).Transformed(_world.Instances.PlaceOf(i));
                all = box.IsFinite ? all.Union(box) : all;
            }

            return all;
        }
    }

    private const string HoldsInstances = "instances";

    private IEnumerable<int> InstanceNumbers => Enumerable.Range(1, Instances);

    private static Bounds Finite(Space space)
    {
        IEnumerable<Bounds> boxes = [.. space.Shapes.Select(s => s.Bounds), .. space.Contents.Meshes.Select(m => MeshTable.BoundsOf(m.Data).Transformed(m.Place))];
        return boxes.Where(b => b.IsFinite).Aggregate(Bounds.Empty, (all, box) => all.Union(box));
    }

    private IEnumerable<SceneTree> FindTrees()
    {
        for (int i = 0; i < _world.Spaces.Length; i++)
        {
            if (_world.Spaces[i] is { Tree: { } tree, Mesh: { } mesh })
            {
                string of = i == 0 ? "the world" : $"object {i}";
                yield return new($"triangles of {of}", tree.Statistics, () => TriangleBvh.Build(mesh.Positions, mesh.Indices, Environment.ProcessorCount));
            }
        }

        if (_world.Instances is { } instances)
        {
            yield return new(HoldsInstances, instances.TreeStatistics, instances.BuildTree);
        }
    }
}

/// <summary>A tree with which rays find what they meet.</summary>
/// <param name="Holds">The name of the things in it: "triangles of the world", "triangles of object 1" or "instances".</param>
/// <param name="Statistics">Its shape and its memory.</param>
/// <param name="Build">Builds such a tree again, to measure how long that takes; the scene keeps its own.</param>
public sealed record SceneTree(string Holds, BvhStatistics Statistics, Action Build)
{
    /// <summary>Memory of the nodes alone.</summary>
    public long NodeBytes => (long)Statistics.Nodes * BvhNode.Bytes;

    /// <summary>Memory of what the leaves hold.</summary>
    public long LeafBytes => Statistics.MemoryBytes - NodeBytes;
}
