using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Acceleration;

/// <summary>Shapes and triangles in coordinates of their own: the world, or an object that instances show.</summary>
internal sealed class Space
{
    /// <summary>Packs the contents of a space.</summary>
    /// <param name="contents">The contents of the space.</param>
    /// <param name="first">Number of its first primitive among the scene's.</param>
    /// <param name="nothing">The number that stands for no primitive.</param>
    /// <param name="largestLoop">The most shapes that rays are tested against one after the other.</param>
    public Space(SpaceContents contents, int first, int nothing, int largestLoop)
    {
        Contents = contents;
        Batches = [.. contents.Shapes.GroupBy(s => s.GetType()).Select(kind => kind.First().CreateBatch([.. kind]))];
        Shapes = [.. contents.Shapes.GroupBy(s => s.GetType()).SelectMany(kind => kind)];
        FirstPrimitive = first;
        foreach (ShapeBatch batch in Batches)
        {
            batch.FirstPrimitive = first;
            first += batch.Count;
        }

        Primitives = new(Shapes, Batches, nothing, largestLoop);
        (Bounds, FiniteBounds) = (Bounds.Empty, Bounds.Empty);
        foreach (Bounds box in Shapes.Select(s => s.Bounds))
        {
            Bounds = Bounds.Union(box);
            FiniteBounds = box.IsFinite ? FiniteBounds.Union(box) : FiniteBounds;
        }

        if (contents.Meshes.Count > 0)
        {
            Mesh = MeshTable.Create(contents.Meshes);
            Mesh.FirstPrimitive = first;
            Tree = TriangleBvh.Build(Mesh.Positions, Mesh.Indices, Environment.ProcessorCount);
            Bounds meshes = contents.Meshes.Aggregate(Bounds.Empty, (all, mesh) => all.Union(MeshTable.BoundsOf(mesh.Data).Transformed(mesh.Place)));
            (Bounds, FiniteBounds) = (Bounds.Union(meshes), FiniteBounds.Union(meshes));
        }
    }

    /// <summary>The description that it was made from.</summary>
    public SpaceContents Contents { get; }

    /// <summary>The shapes in the order of their primitive numbers.</summary>
    public Shape[] Shapes { get; }

    /// <summary>The shapes packed by kind.</summary>
    public ShapeBatch[] Batches { get; }

    /// <summary>Meets rays with the shapes.</summary>
    public PrimitiveList Primitives { get; }

    /// <summary>The triangles, whose numbers follow those of the shapes; null where there are none.</summary>
    public MeshTable? Mesh { get; }

    /// <summary>Meets rays with the triangles.</summary>
    public TriangleBvh? Tree { get; }

    /// <summary>Number of the first primitive.</summary>
    public int FirstPrimitive { get; }

    /// <summary>Number of primitives.</summary>
    public int Count => Shapes.Length + (Mesh?.Count ?? 0);

    /// <summary>The box around everything; infinite where something is.</summary>
    public Bounds Bounds { get; }

    /// <summary>The box around all that has an end.</summary>
    public Bounds FiniteBounds { get; }

    /// <summary>True where anything in it shines.</summary>
    public bool Shines => Array.Exists(Shapes, s => s.Material.Traits.Emits) || Contents.Meshes.Exists(m => m.Materials.Any(material => material.Traits.Emits));

    /// <summary>The tables of all surfaces.</summary>
    public IEnumerable<SurfaceTable> Tables => Mesh is null ? Batches : [.. Batches, Mesh];

    /// <summary>The material of a primitive of the space, by its number among the scene's.</summary>
    public Material MaterialOf(int primitive)
    {
        int index = primitive - FirstPrimitive;
        return index < Shapes.Length ? Shapes[index].Material : MaterialOfTriangle[index - Shapes.Length];
    }

    /// <summary>Returns the number of the shape that a primitive of the space is, or, further on, of the mesh that it is a triangle of.</summary>
    public int SurfaceOf(int primitive)
    {
        int index = primitive - FirstPrimitive;
        return index < Shapes.Length ? index : Shapes.Length + ((TriangleMaterials)MaterialOfTriangle).MeshOf(index - Shapes.Length);
    }

    /// <summary>Returns the description that a primitive of the space was made from; null where that is not kept.</summary>
    public ShapeDescription? SourceOf(int primitive) =>
        SurfaceOf(primitive) is var i && i < Shapes.Length ? Shapes[i].Source : Contents.Meshes[i - Shapes.Length].Source;

    /// <summary>The material of each triangle.</summary>
    public IReadOnlyList<Material> MaterialOfTriangle => field ??= new TriangleMaterials(Contents.Meshes);

    /// <summary>The nearest hit of one ray, whose direction may be of any length.</summary>
    /// <param name="ray">The ray, in coordinates of the space.</param>
    /// <param name="distance">In: how far hits count; out: that of the hit, if there is one. In multiples of the direction.</param>
    /// <returns>The primitive; −1 where nothing is hit.</returns>
    public int ClosestHit(in SpaceRay ray, ref float distance)
    {
        int found = MeetShapes(ray, ref distance);
        if (Tree is not null)
        {
            found = Tree.ClosestHit(ray.Origin, ray.Direction, ref distance, out int triangle) ? Mesh!.FirstPrimitive + triangle : found;
        }

        return found;
    }

    /// <summary>Returns the cost of finding the nearest hit of one ray: nodes visited plus triangles tested.</summary>
    /// <param name="ray">The ray, in coordinates of the space.</param>
    /// <param name="distance">The largest distance at which hits count, in multiples of the direction.</param>
    public long Cost(in SpaceRay ray, float distance)
    {
        MeetShapes(ray, ref distance);
        return Tree?.Cost(ray.Origin, ray.Direction, distance) ?? 0;
    }

    /// <summary>Returns whether anything stands in the way of one ray.</summary>
    /// <param name="ray">The ray, in coordinates of the space.</param>
    /// <param name="distance">The distance over which it must be free, in multiples of the direction.</param>
    /// <param name="skip">A primitive that does not count; −1 for none.</param>
    public bool AnyHit(in SpaceRay ray, float distance, int skip)
    {
        if (Shapes.Length > 0)
        {
            float length = ray.Direction.Norm();
            MaskW free = MaskW.First(1);
            Primitives.Occlude(ray.Origin, ray.Direction * (1 / length), distance * length, skip, ref free);
            if (!free.Any)
            {
                return true;
            }
        }

        return Tree is not null && Tree.AnyHit(ray.Origin, ray.Direction, distance);
    }

    // Shortens a ray to the nearest of the shapes, and says which one it is; -1 for none.
    private int MeetShapes(in SpaceRay ray, ref float distance)
    {
        if (Shapes.Length == 0)
        {
            return -1;
        }

        float length = ray.Direction.Norm();
        Vector3 unit = ray.Direction * (1 / length);
        FloatW shortened = distance * length;
        UIntW primitive = uint.MaxValue;
        Primitives.Shorten(ray.Origin, unit, ref shortened, ref primitive, lanes: 1);
        if (primitive[0] == uint.MaxValue)
        {
            return -1;
        }

        distance = float.Min(distance, shortened[0] / length);
        return (int)primitive[0];
    }

    // The materials of the meshes' triangles one after the other, without an entry for each.
    private sealed class TriangleMaterials(IReadOnlyList<PlacedMesh> meshes) : IReadOnlyList<Material>
    {
        private readonly int[] _first = [.. meshes.Select((_, i) => meshes.Take(i).Sum(m => m.Data.TriangleCount))];

        public int Count => meshes.Sum(m => m.Data.TriangleCount);

        public Material this[int index]
        {
            get
            {
                int mesh = MeshOf(index);
                return Of(meshes[mesh], index - _first[mesh]);
            }
        }

        public int MeshOf(int index)
        {
            int mesh = Array.BinarySearch(_first, index);
            return mesh >= 0 ? mesh : ~mesh - 1;
        }

        public IEnumerator<Material> GetEnumerator() =>
            meshes.SelectMany(m => Enumerable.Range(0, m.Data.TriangleCount).Select(t => Of(m, t))).GetEnumerator();

        System.Collections.IEnumerator System.Collections.IEnumerable.GetEnumerator() => GetEnumerator();

        private static Material Of(PlacedMesh mesh, int triangle)
        {
            int material = mesh.Data.MaterialOfTriangle?[triangle] ?? 0;
            return mesh.Materials[(uint)material < (uint)mesh.Materials.Length ? material : 0];
        }
    }
}

/// <summary>A ray in the coordinates of a space.</summary>
/// <param name="Origin">The point from which it starts.</param>
/// <param name="Direction">Its direction, of any length, in which distances are measured.</param>
internal readonly record struct SpaceRay(Vector3 Origin, Vector3 Direction)
{
    /// <summary>In the world: the instance from whose surface it starts; 0 for none.</summary>
    public int StartInstance { get; init; }

    /// <summary>The point from which it starts, in that instance's space.</summary>
    public Vector3 InnerStart { get; init; }

    /// <summary>One ray of a packet.</summary>
    /// <param name="origin">The points from which the rays start.</param>
    /// <param name="direction">Their directions.</param>
    /// <param name="lane">Which of them.</param>
    public static SpaceRay Of(in Vec3W origin, in Vec3W direction, int lane) => new(
        new(origin.X[lane], origin.Y[lane], origin.Z[lane]), new(direction.X[lane], direction.Y[lane], direction.Z[lane]));
}
