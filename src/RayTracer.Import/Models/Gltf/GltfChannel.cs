namespace RayTracer.Import;

/// <summary>The channels of a picture that a texture shows.</summary>
internal enum GltfChannel
{
    /// <summary>Red as a number.</summary>
    Red,

    /// <summary>Green as a number.</summary>
    Green,

    /// <summary>Blue as a number.</summary>
    Blue,

    /// <summary>The opacity.</summary>
    Alpha,

    /// <summary>The colours, decoded from sRGB.</summary>
    Color,

    /// <summary>All three numbers as they are.</summary>
    All,
}
