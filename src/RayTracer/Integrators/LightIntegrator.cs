using RayTracer.Rendering;

namespace RayTracer.Description;

/// <summary>
/// Light tracing (Arvo 1986; Dutré, Lafortune &amp; Willems 1993): paths start at the lights, and each of their vertices is connected with the camera. It
/// cannot find what the camera sees in mirrors, through glass and through masks, but for the lights themselves.
/// </summary>
internal sealed class LightIntegrator() : LightTracingIntegrator("light", Strategies.Seen | Strategies.Camera);
