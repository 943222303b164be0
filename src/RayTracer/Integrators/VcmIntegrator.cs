using RayTracer.Rendering;

namespace RayTracer.Description;

/// <summary>
/// Vertex connection and merging (Georgiev, Křivánek, Davidovič &amp; Slusallek 2012; Hachisuka, Pantaleoni &amp; Jensen 2012): bidirectional path tracing and
/// photon mapping, weighed against each other.
/// </summary>
internal sealed class VcmIntegrator() : LightTracingIntegrator(
    "vcm", Strategies.Seen | Strategies.Lights | Strategies.Camera | Strategies.Connections | Strategies.Merges);
