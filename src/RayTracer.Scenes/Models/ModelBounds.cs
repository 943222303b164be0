using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Scenes;

/// <summary>How large models are; meshes that are shown many times are measured once.</summary>
internal sealed class ModelBounds
{
    private readonly Dictionary<MeshData, Bounds> _meshes = new(ReferenceEqualityComparer.Instance);

    /// <summary>The middle of the box around shapes and half its diagonal; the origin and 1 where there is nothing.</summary>
    public (Vector3 Center, float Extent) CenterAndExtent(IEnumerable<ShapeDescription> shapes)
    {
        Bounds all = Bounds.Empty;
        foreach (ShapeDescription shape in shapes)
        {
            all = all.Union(Of(shape, Transform.Identity));
        }

        if (!all.IsFinite)
        {
            return (Vector3.Zero, 1);
        }

        float extent = (all.Maximum * 0.5f - all.Minimum * 0.5f).Norm();
        return (all.Minimum * 0.5f + all.Maximum * 0.5f, extent > 0 && float.IsFinite(extent) ? extent : 1);
    }

    private Bounds Of(ShapeDescription shape, Transform around)
    {
        Transform world = shape.Transform.Reverse().Aggregate(around, (map, step) => map * Step(step));
        return shape switch
        {
            MeshDescription { Data: { } data } => Of(Of(data), world),
            GroupDescription group => group.Shapes.Aggregate(Bounds.Empty, (all, part) => all.Union(Of(part, world))),
            InstanceDescription { Of: { } of } => Of(of, world),
            _ => Bounds.Empty,
        };
    }

    private Bounds Of(MeshData mesh)
    {
        if (_meshes.TryGetValue(mesh, out Bounds known))
        {
            return known;
        }

        Bounds bounds = Bounds.Empty;
        foreach (Vector3 position in mesh.Positions)
        {
            if (position.IsFinite())
            {
                bounds = bounds.Union(new(position, position));
            }
        }

        _meshes.Add(mesh, bounds);
        return bounds;
    }

    private static Bounds Of(Bounds bounds, Transform map)
    {
        Bounds image = Bounds.Empty;
        for (int corner = 0; bounds.IsFinite && corner < 8; corner++)
        {
            Vector3 at = map.Point(new Vector3(
                (corner & 1) == 0 ? bounds.Minimum.X : bounds.Maximum.X,
                (corner & 2) == 0 ? bounds.Minimum.Y : bounds.Maximum.Y,
                (corner & 4) == 0 ? bounds.Minimum.Z : bounds.Maximum.Z));
            image = image.Union(new(at, at));
        }

        return image;
    }

    // Importers place things by matrices alone.
    private static Transform Step(TransformDescription step) => step.Matrix is { Count: > 0 } m
        ? new(new(m[0], m[1], m[2], m[3]), new(m[4], m[5], m[6], m[7]), new(m[8], m[9], m[10], m[11]))
        : Transform.Identity;
}
