using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Rendering;

/// <summary>A shape or mesh of a scene where it stands in the world.</summary>
/// <param name="Source">The thing that it was made from, as <see cref="Scene.SourceOf"/> says.</param>
/// <param name="Shape">The shape, in coordinates of its own; null for a mesh.</param>
/// <param name="Mesh">The mesh, in coordinates of its own; null for a shape.</param>
/// <param name="Place">From those coordinates into the world.</param>
public readonly record struct PlacedSurface(ShapeDescription? Source, Shape? Shape, MeshData? Mesh, Transform Place)
{
    /// <summary>The box around it, in the world; infinite where it has no end.</summary>
    public Bounds Bounds => (Shape?.Bounds ?? MeshTable.BoundsOf(Mesh!)).Transformed(Place);

    /// <summary>All of a world.</summary>
    internal static IEnumerable<PlacedSurface> All(World world)
    {
        IEnumerable<PlacedSurface> itself = Of(world.Itself, null, Transform.Identity);
        return world.Instances is not { } instances
            ? itself
            : itself.Concat(Enumerable.Range(1, instances.Count).SelectMany(i => Of(instances.SpaceOf(i), instances.SourceOf(i), instances.PlaceOf(i))));
    }

    private static IEnumerable<PlacedSurface> Of(Space space, ShapeDescription? source, Transform place) =>
        space.Shapes.Select(s => new PlacedSurface(source ?? s.Source, s, null, place))
            .Concat(space.Contents.Meshes.Select(m => new PlacedSurface(source ?? m.Source, null, m.Data, place * m.Place)));
}
