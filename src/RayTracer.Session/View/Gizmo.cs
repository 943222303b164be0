using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;

namespace RayTracer.Session;

/// <summary>Where a thing is, to draw handles around.</summary>
/// <param name="Center">The middle of the box around it.</param>
/// <param name="Radius">Half the box's diagonal.</param>
/// <param name="Minimum">The box's smallest coordinates.</param>
/// <param name="Maximum">Its largest coordinates.</param>
public sealed record Gizmo(Vector3 Center, float Radius, Vector3 Minimum, Vector3 Maximum)
{
    /// <summary>Finds a thing.</summary>
    /// <param name="shown">The scene.</param>
    /// <param name="pointer">The thing.</param>
    /// <exception cref="SessionException">It is nothing that can be seen, or it has no end.</exception>
    public static Gizmo Of(ShownScene shown, string pointer)
    {
        Bounds all = Bounds.Empty;
        foreach (PlacedSurface surface in shown.Scene.Surfaces().Where(s => Picking.IsWithin(shown.PointerOf(s.Source), pointer)))
        {
            all = all.Union(surface.Bounds);
        }

        return all.IsFinite
            ? new((all.Minimum + all.Maximum) * 0.5f, ((all.Maximum - all.Minimum) * 0.5f).Norm(), all.Minimum, all.Maximum)
            : throw new SessionException("There is nothing there with a size.", SessionFault.Missing);
    }
}
