namespace RayTracer.Imaging;

/// <summary>The resolution of the colour differences in a JPEG file.</summary>
public enum JpegChroma
{
    /// <summary>One of each for every pixel (4:4:4).</summary>
    Full,

    /// <summary>One of each for every square of four pixels, their mean (4:2:0): smaller files, blurred edges between colours.</summary>
    Half,
}
