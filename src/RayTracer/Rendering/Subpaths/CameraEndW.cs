using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>The vertices of camera paths that light paths are connected or merged with, beside their surfaces.</summary>
internal struct CameraEndW
{
    /// <summary>The fraction of light that gets to the camera.</summary>
    public RgbW Throughput;

    /// <summary>The factor on light whose path has a wavelength: 1 where the camera's path has it already.</summary>
    public RgbW Color;

    /// <summary>The partial sums.</summary>
    public SubpathSumsW Sums;

    /// <summary>Numbers of the camera paths.</summary>
    public UIntW Path;

    /// <summary>Numbers of the vertices on them, from 0.</summary>
    public UIntW Number;

    /// <summary>The media through which they came; used only where paths track them.</summary>
    public UIntW Media;

    /// <summary>Times in seconds; used only where something moves.</summary>
    public FloatW Time;
}
