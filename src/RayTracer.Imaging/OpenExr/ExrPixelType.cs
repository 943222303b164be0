namespace RayTracer.Imaging;

/// <summary>The types of values of OpenEXR channels; the values are the file format's.</summary>
public enum ExrPixelType
{
    /// <summary>32-bit unsigned integer; written in layers only.</summary>
    Uint = 0,

    /// <summary>16-bit float: 11 bits of precision, up to 65504.</summary>
    Half = 1,

    /// <summary>32-bit float.</summary>
    Float = 2,
}
