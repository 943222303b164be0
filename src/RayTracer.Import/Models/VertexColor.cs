using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Colours of vertices: model files hold what is to be seen on a screen, that is, sRGB.</summary>
internal static class VertexColor
{
    /// <summary>Linear light of a value from 0 to 1.</summary>
    public static float Decode(float encoded) => encoded > 0 ? (float)SrgbCurve.Decode(float.Min(encoded, 1)) : 0;

    /// <summary>Linear light of a number in a PLY file: whole ones are codes from 0 to the type's largest, others go from 0 to 1.</summary>
    public static float Decode(float number, PlyType type) => type switch
    {
        PlyType.Float32 or PlyType.Float64 => Decode(number),
        PlyType.UInt16 => SrgbCurve.Decode16((ushort)number),
        _ => SrgbCurve.Decode8((byte)Math.Clamp(number, 0, 255)),
    };
}
