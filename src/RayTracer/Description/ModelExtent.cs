using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Description;

/// <summary>The extent of descriptions of shapes, without building them: enough to place a camera.</summary>
internal static class ModelExtent
{
    /// <summary>A box around all shapes that have an end, when the shutter opens at time 0; empty where there are none.</summary>
    /// <param name="shapes">The shapes. Files that they name are not read.</param>
    public static Bounds Of(IEnumerable<ShapeDescription> shapes)
    {
        SceneBuilder builder = new((_, _) => new(1, 1));
        Dictionary<object, Bounds> known = new(ReferenceEqualityComparer.Instance);
        return shapes.Aggregate(Bounds.Empty, (all, shape) => all.Union(Of(shape, Transform.Identity, builder, known, 0)));
    }

    private static Bounds Of(ShapeDescription shape, in Transform outer, SceneBuilder builder, Dictionary<object, Bounds> known, int nesting)
    {
        Transform place = outer * TransformSteps.Motion(shape, shape.Transform, shape.Motion, builder).At(0);
        if (nesting > 200)
        {
            return Bounds.Empty;
        }

        Bounds box;
        switch (shape)
        {
            case GroupDescription group:
                Bounds all = Bounds.Empty;
                foreach (ShapeDescription inner in group.Shapes)
                {
                    all = all.Union(Of(inner, place, builder, known, nesting + 1));
                }

                return all;
            case InstanceDescription instance:
                return instance.Of is null ? Bounds.Empty : Of(instance.Of, place, builder, known, nesting + 1);
            case MeshDescription mesh:
                box = Of((IReadOnlyList<Vector3>?)mesh.Data?.Positions ?? mesh.Positions, known);
                break;
            default:
                box = shape.Build(builder)?.Bounds ?? Bounds.Empty;
                break;
        }

        box = box.Transformed(place);
        return box.IsFinite ? box : Bounds.Empty;
    }

    // Meshes that are shown many times are measured once.
    private static Bounds Of(IReadOnlyList<Vector3> positions, Dictionary<object, Bounds> known)
    {
        if (!known.TryGetValue(positions, out Bounds all))
        {
            all = positions.Where(p => p.IsFinite()).Aggregate(Bounds.Empty, (box, p) => box.Union(new(p, p)));
            known.Add(positions, all);
        }

        return all;
    }
}
