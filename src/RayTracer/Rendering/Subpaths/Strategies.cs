namespace RayTracer.Rendering;

/// <summary>The ways to make a path of two subpaths; what an integrator uses of them is all that it is.</summary>
[Flags]
internal enum Strategies
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>A camera path meets a light.</summary>
    Seen = 1,

    /// <summary>A camera path asks the lights.</summary>
    Lights = 1 << 1,

    /// <summary>A light path is connected with the camera.</summary>
    Camera = 1 << 2,

    /// <summary>Vertices of a camera path and of a light path are connected.</summary>
    Connections = 1 << 3,

    /// <summary>Vertices of camera paths and of light paths that are near to each other are taken for the same.</summary>
    Merges = 1 << 4,
}
