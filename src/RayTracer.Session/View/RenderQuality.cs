namespace RayTracer.Session;

/// <summary>How many samples a picture gets, in words. All are squares, as some samplers need.</summary>
public enum RenderQuality
{
    /// <summary>To look at while working.</summary>
    Draft = 16,

    /// <summary>To show to others.</summary>
    Good = 256,

    /// <summary>To print.</summary>
    Final = 1024,
}
