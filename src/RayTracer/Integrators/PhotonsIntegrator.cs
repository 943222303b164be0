using RayTracer.Rendering;

namespace RayTracer.Description;

/// <summary>
/// Progressive photon mapping (Hachisuka, Ogaki &amp; Jensen 2008; Knaus &amp; Zwicker 2011): light that comes by way of other surfaces is that of the light
/// paths' vertices near by, within a circle that shrinks from sample to sample; what comes straight from the lights is computed as by path tracing.
/// </summary>
internal sealed class PhotonsIntegrator() : LightTracingIntegrator("photons", Strategies.Seen | Strategies.Lights | Strategies.Merges);
