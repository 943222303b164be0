using System.Buffers.Binary;

namespace RayTracer.Import;

/// <summary>The types of an accessor's numbers (glTF 2.0, section 3.6.2.2), by their codes.</summary>
internal enum GltfComponentType
{
    /// <summary>Signed, one byte.</summary>
    Byte = 5120,

    /// <summary>Unsigned, one byte.</summary>
    UnsignedByte = 5121,

    /// <summary>Signed, two bytes.</summary>
    Short = 5122,

    /// <summary>Unsigned, two bytes.</summary>
    UnsignedShort = 5123,

    /// <summary>Unsigned, four bytes.</summary>
    UnsignedInt = 5125,

    /// <summary>Floating point, four bytes.</summary>
    Float = 5126,
}

/// <summary>Reads single numbers of an accessor.</summary>
internal static class GltfComponent
{
    /// <summary>Bytes of one number.</summary>
    public static int Size(GltfComponentType type) => type switch
    {
        GltfComponentType.Byte or GltfComponentType.UnsignedByte => 1,
        GltfComponentType.Short or GltfComponentType.UnsignedShort => 2,
        _ => 4,
    };

    /// <summary>A whole number.</summary>
    public static uint Whole(GltfComponentType type, ReadOnlySpan<byte> at) => type switch
    {
        GltfComponentType.UnsignedByte => at[0],
        GltfComponentType.UnsignedShort => BinaryPrimitives.ReadUInt16LittleEndian(at),
        _ => BinaryPrimitives.ReadUInt32LittleEndian(at),
    };

    /// <summary>A number as a float; normalised whole numbers become 0 to 1, signed ones −1 to 1 (glTF 2.0, section 3.11).</summary>
    public static float Real(GltfComponentType type, bool isNormalized, ReadOnlySpan<byte> at)
    {
        (float value, float largest) = type switch
        {
            GltfComponentType.Byte => ((sbyte)at[0], (float)sbyte.MaxValue),
            GltfComponentType.UnsignedByte => (at[0], byte.MaxValue),
            GltfComponentType.Short => (BinaryPrimitives.ReadInt16LittleEndian(at), short.MaxValue),
            GltfComponentType.UnsignedShort => (BinaryPrimitives.ReadUInt16LittleEndian(at), ushort.MaxValue),
            GltfComponentType.UnsignedInt => (BinaryPrimitives.ReadUInt32LittleEndian(at), uint.MaxValue),
            _ => (BinaryPrimitives.ReadSingleLittleEndian(at), 1f),
        };
        return isNormalized ? float.Max(value / largest, -1) : value;
    }
}
