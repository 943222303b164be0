namespace RayTracer.Imaging;

/// <summary>The compressions of pixels in OpenEXR files, all without loss; the values are the file format's.</summary>
public enum ExrCompression
{
    /// <summary>Not at all.</summary>
    None = 0,

    /// <summary>Run lengths, one row at a time.</summary>
    Rle = 1,

    /// <summary>Deflate, one row at a time.</summary>
    Zips = 2,

    /// <summary>Deflate, sixteen rows at a time: the smallest files of the four.</summary>
    Zip = 3,
}
