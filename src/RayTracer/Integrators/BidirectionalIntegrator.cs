using RayTracer.Rendering;

namespace RayTracer.Description;

/// <summary>
/// Bidirectional path tracing (Veach 1997, chapter 10; Lafortune &amp; Willems 1993): every vertex of a camera path is connected with every vertex of a light
/// path. It cannot find light of a point that comes to what the camera sees in a mirror by way of another mirror.
/// </summary>
internal sealed class BidirectionalIntegrator() : LightTracingIntegrator(
    "bidirectional", Strategies.Seen | Strategies.Lights | Strategies.Camera | Strategies.Connections);
