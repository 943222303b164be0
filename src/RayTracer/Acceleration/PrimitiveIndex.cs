using RayTracer.Numerics;

namespace RayTracer.Acceleration;

/// <summary>
/// Which shapes of one batch the lanes of a packet have hit. Often all hit the same one: its constants are then
/// broadcast, which is several times faster than gathering them.
/// </summary>
public readonly unsafe struct PrimitiveIndex
{
    private readonly UIntW _offset;
    private readonly int _uniform;

    /// <summary>One shape for all lanes.</summary>
    /// <param name="index">Its index in the batch.</param>
    /// <param name="stride">Floats a shape in the table.</param>
    public PrimitiveIndex(int index, int stride)
    {
        _uniform = index * stride;
        _offset = default;
    }

    /// <summary>A shape for each lane.</summary>
    /// <param name="index">Their indices in the batch.</param>
    /// <param name="stride">Floats a shape in the table.</param>
    public PrimitiveIndex(UIntW index, int stride)
    {
        _uniform = -1;
        _offset = index * (uint)stride;
    }

    /// <summary>The shapes' places in the table: index · stride.</summary>
    internal UIntW Offset => _uniform >= 0 ? (uint)_uniform : _offset;

    /// <summary>One constant of each lane's shape.</summary>
    /// <param name="table">The packed table.</param>
    /// <param name="constant">Position of the constant in a shape's entry.</param>
    public FloatW Read(float* table, int constant) =>
        _uniform >= 0 ? table[_uniform + constant] : FloatW.Gather(table + constant, _offset);

    /// <summary>Three constants in a row.</summary>
    /// <param name="table">The packed table.</param>
    /// <param name="constant">Position of the first one in a shape's entry.</param>
    public Vec3W ReadVector(float* table, int constant) =>
        new(Read(table, constant), Read(table, constant + 1), Read(table, constant + 2));
}
