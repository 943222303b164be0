using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Lights;

/// <summary>
/// A light without extent: from each lit point there is one way to it. Its density is a delta function, and rays never meet it.
/// </summary>
/// <param name="position">The position in its space.</param>
/// <param name="axis">A direction in the light's space.</param>
/// <param name="motion">The place of its own space in the world. Sizes do not matter: only the position and the axis's direction.</param>
public abstract unsafe class PunctualLight(Vector3 position, Vector3 axis, Motion motion) : LightSource(0, -1)
{
    // Nearer than this, the square of the distance has no inverse in single precision.
    private const float SmallestSquare = 1e-37f;
    private readonly bool _moves = !motion.IsStill;
    private readonly Vector3 _position = motion.At(0).Point(position);
    private readonly Vector3 _axis = motion.At(0).Vector(axis).Unit();

    /// <inheritdoc/>
    public sealed override bool IsDelta => true;

    /// <inheritdoc/>
    public sealed override void Pdf(in LightHitW hit, out FloatW pdf) => pdf = 0f;

    /// <summary>The position and the direction of its axis, in the world.</summary>
    /// <param name="time">The times in seconds; used only where it moves.</param>
    /// <param name="place">The position.</param>
    /// <param name="direction">The axis, of unit length.</param>
    protected void Place(in FloatW time, out Vec3W place, out Vec3W direction)
    {
        place = _position;
        direction = _axis;
        if (_moves)
        {
            PlaceAt(time, out place, out direction);
        }
    }

    /// <summary>The one sample of a light at a point.</summary>
    /// <param name="to">The way from the lit points to the light.</param>
    /// <param name="sample">The sample.</param>
    /// <param name="inverseSquare">One over the squared distance; 0 where that is too small.</param>
    protected static void Towards(in Vec3W to, out ShapeSampleW sample, out FloatW inverseSquare)
    {
        FloatW square = Vec3W.Dot(to, to);
        MaskW isApart = square > SmallestSquare;
        inverseSquare = isApart.Select(1f / square, 0f);
        FloatW inverse = FloatW.Sqrt(inverseSquare);
        sample.Direction = to * inverse;
        sample.Distance = square * inverse;
        sample.Cosine = 1f;
        sample.InversePdf = isApart.Select(1f, 0f);
        sample.U = sample.V = default;
    }

    /// <summary>A box around all places of the position while the shutter is open.</summary>
    protected Bounds BoundsOfPosition((double Open, double Close) shutter) => motion.Bound(new(position, position), shutter.Open, shutter.Close);

    private void PlaceAt(in FloatW time, out Vec3W place, out Vec3W direction)
    {
        float* memory = stackalloc float[InstanceMaps.Floats];
        InstanceMaps maps = new(memory);
        maps.Fill(motion, time);
        place = maps.Point(position);
        direction = Vec3W.Normalize(maps.Vector(axis));
    }
}
