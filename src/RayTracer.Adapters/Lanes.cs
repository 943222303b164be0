using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Adapters;

/// <summary>Directions and colours that are found lane by lane.</summary>
/// <param name="memory">Room for <see cref="Floats"/> numbers.</param>
internal readonly unsafe ref struct Lanes(Span<float> memory)
{
    private readonly Span<float> _memory = memory;

    /// <summary>The numbers that it needs room for.</summary>
    public static int Floats => 6 * FloatW.Count;

    /// <summary>The directions that were set.</summary>
    public Vec3W Direction => new(Row(0), Row(1), Row(2));

    /// <summary>The colours that were set.</summary>
    public RgbW Color => new(Row(3), Row(4), Row(5));

    /// <summary>Sets those of a lane.</summary>
    public void Set(int lane, Textbook.Vector direction, Textbook.Rgb color)
    {
        ReadOnlySpan<double> values = [direction.X, direction.Y, direction.Z, color.R, color.G, color.B];
        for (int row = 0; row < values.Length; row++)
        {
            _memory[(row * FloatW.Count) + lane] = (float)values[row];
        }
    }

    /// <summary>The vector of a lane.</summary>
    public static Textbook.Vector Vector(in Vec3W v, int lane) => new(v.X[lane], v.Y[lane], v.Z[lane]);

    /// <summary>The mask of the lanes whose bits are set.</summary>
    public static MaskW Mask(uint bits)
    {
        Span<int> lanes = stackalloc int[FloatW.Count];
        for (int lane = 0; lane < lanes.Length; lane++)
        {
            lanes[lane] = (bits >> lane & 1) != 0 ? -1 : 0;
        }

        return new(new Vector<int>(lanes));
    }

    private FloatW Row(int row) => new(new Vector<float>(_memory.Slice(row * FloatW.Count, FloatW.Count)));
}
