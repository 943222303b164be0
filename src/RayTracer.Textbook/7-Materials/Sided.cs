namespace RayTracer.Textbook;

/// <summary>One material outside and one behind.</summary>
/// <param name="front">The material that rays from outside meet.</param>
/// <param name="back">The material that rays from behind meet; null for black.</param>
public sealed class Sided(IMaterial front, IMaterial? back) : IMaterial
{
    private static readonly Diffuse s_black = new(new Solid(Rgb.Black));

    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) => Seen(hit).Evaluate(Outside(hit), toViewer, toLight);

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to) => Seen(hit).Pdf(Outside(hit), from, to);

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler) => Seen(hit).Sample(Outside(hit), from, sampler);

    /// <inheritdoc/>
    public IReadOnlyList<Scattering> Mirrors(in Hit hit, Vector from) => Seen(hit).Mirrors(Outside(hit), from);

    /// <inheritdoc/>
    public Rgb Matt(in Hit hit, Vector toViewer) => Seen(hit).Matt(Outside(hit), toViewer);

    /// <inheritdoc/>
    public Rgb Ambient(in Hit hit, Vector toViewer) => Seen(hit).Ambient(Outside(hit), toViewer);

    private IMaterial Seen(in Hit hit) => hit.Inside ? back ?? s_black : front;

    // Either takes its rays for rays from outside, but for glass that is seen from outside only.
    private static Hit Outside(in Hit hit) => hit with { Inside = false };
}
