namespace RayTracer.Textbook;

/// <summary>Computes the light that comes along a ray: an estimate whose mean over many samples is right.</summary>
public interface IIntegrator
{
    /// <summary>The radiance that comes back along a ray of the camera.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="ray">The ray.</param>
    /// <param name="sampler">The source of random numbers.</param>
    Rgb Radiance(Scene scene, Ray ray, ISampler sampler);

    /// <summary>Prepares for one sample of each pixel.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="pass">Number of the sample, from 0.</param>
    /// <param name="pixels">The number of pixels.</param>
    /// <param name="sampler">The source of random numbers.</param>
    void BeginPass(Scene scene, int pass, int pixels, ISampler sampler)
    {
    }
}

/// <summary>An integrator that sends paths from the lights, which may end in any pixel.</summary>
public interface ILightPathIntegrator : IIntegrator
{
    /// <summary>Follows one path from a light.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="sampler">The source of random numbers.</param>
    /// <param name="splat">Takes light, with the column and row at which the camera sees it.</param>
    void TraceLight(Scene scene, ISampler sampler, Action<double, double, Rgb> splat);
}
