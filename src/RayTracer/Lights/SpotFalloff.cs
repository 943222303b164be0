namespace RayTracer.Lights;

/// <summary>The ways in which the intensity of a spot light falls between its beam and its edge.</summary>
public enum SpotFalloff
{
    /// <summary>In proportion to the angle.</summary>
    Linear,

    /// <summary>As the square of a number that falls in proportion to the angle's cosine (glTF's KHR_lights_punctual).</summary>
    Smooth,
}
