using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Description;

/// <summary>The place and size that an editor gives a new shape.</summary>
/// <param name="Target">The point at which its middle is put.</param>
/// <param name="Right">Unit vector to the right in the picture.</param>
/// <param name="Up">Unit vector upwards in the picture.</param>
/// <param name="Towards">Unit vector from the target to the camera.</param>
/// <param name="Size">A length that is well seen: about an eighth of the picture's height.</param>
public sealed record SketchView(Vector3 Target, Vector3 Right, Vector3 Up, Vector3 Towards, float Size)
{
    /// <summary>The radiance of a new lamp: what one of the size of new things needs to light what is around it.</summary>
    public const float LampRadiance = 20;

    /// <summary>True where the shape is to shine.</summary>
    public bool Shines { get; init; }

    /// <summary>The file that the shape is to be read from; null where there is none.</summary>
    public string? File { get; init; }

    /// <summary>The direction, in sizes, from a thing to a light that is put up for it: above, and before it.</summary>
    public Vector3 Above => (Up * 3) + (Towards * 2);

    /// <summary>The intensity of a new light without extent: that of a lamp of this size.</summary>
    public Rgb Intensity => Rgb.White * (LampRadiance * Size * Size);

    /// <summary>The axis of the world that points most at the camera.</summary>
    public Vector3 Facing
    {
        get
        {
            Vector3 a = Vector3.Abs(Towards);
            int axis = a.X > a.Y && a.X > a.Z ? 0 : a.Y > a.Z ? 1 : 2;
            Vector3 facing = default;
            facing[axis] = Towards[axis] < 0 ? -1 : 1;
            return facing;
        }
    }

    /// <summary>The point that lies an offset, in sizes, from the target.</summary>
    public Vector3 At(Vector3 offset) => Snap(Target + (offset * Size));

    /// <summary>A vector rounded to hundredths of the size.</summary>
    public Vector3 Snap(Vector3 v)
    {
        double step = Size / 100;
        return new(Round(v.X), Round(v.Y), Round(v.Z));

        float Round(double x) => (float)(Math.Round(x / step) * step);
    }
}

/// <summary>As what an editor offers to add a shape.</summary>
[Flags]
public enum SketchKinds
{
    /// <summary>Not at all: it consists of long lists, which are written as text.</summary>
    None = 0,

    /// <summary>As a shape.</summary>
    Shape = 1,

    /// <summary>As a light.</summary>
    Light = 2,
}
