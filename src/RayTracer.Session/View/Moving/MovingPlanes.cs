using System.Runtime.CompilerServices;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>Light that is filtered, a plane for each number, so that a register holds neighbours.</summary>
/// <param name="rows">How pixels lie in the planes.</param>
internal sealed unsafe class MovingPlanes(PaddedRows rows)
{
    private readonly PinnedBuffer<float> _light = new(4L * rows.Size);

    /// <summary>How pixels lie in the planes.</summary>
    public PaddedRows Rows => rows;

    /// <summary>Red.</summary>
    public float* Red => _light.Pointer;

    /// <summary>Green.</summary>
    public float* Green => _light.Pointer + rows.Size;

    /// <summary>Blue.</summary>
    public float* Blue => _light.Pointer + (2 * rows.Size);

    /// <summary>The variance of the luminance.</summary>
    public float* Variance => _light.Pointer + (3 * rows.Size);

    /// <summary>The light of pixels.</summary>
    /// <param name="at">The place of the first.</param>
    public RgbW this[int at]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(FloatW.Load(Red + at), FloatW.Load(Green + at), FloatW.Load(Blue + at));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            value.R.Store(Red + at);
            value.G.Store(Green + at);
            value.B.Store(Blue + at);
        }
    }
}

/// <summary>What a filter goes by, beside the light, laid out as <see cref="MovingPlanes"/>.</summary>
internal sealed unsafe class MovingGuides
{
    private readonly PinnedBuffer<uint> _things;
    private readonly PinnedBuffer<float> _depth;

    /// <summary>Makes room.</summary>
    /// <param name="rows">How pixels lie in the planes.</param>
    public MovingGuides(PaddedRows rows)
    {
        (Seen, _things, _depth) = (new(rows), new(rows.Size), new(rows.Size));
        new Span<uint>(_things.Pointer, rows.Size).Fill(uint.MaxValue);
    }

    /// <summary>What is seen.</summary>
    public SeenPlanes Seen { get; }

    /// <summary>The things' numbers; <see cref="uint.MaxValue"/> around the picture.</summary>
    public uint* Things => _things.Pointer;

    /// <summary>The logarithm of the distance, which a plane seen from anywhere changes slowly.</summary>
    public float* Depth => _depth.Pointer;
}
