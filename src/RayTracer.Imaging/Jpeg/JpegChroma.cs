namespace RayTracer.Imaging;

/// <summary>How many differences of colour a JPEG file keeps.</summary>
public enum JpegChroma
{
    /// <summary>One of each for every pixel (4:4:4).</summary>
    Full,

    /// <summary>One of each for every square of four pixels, their mean (4:2:0): smaller files, blurred edges between colours.</summary>
    Half,
}
