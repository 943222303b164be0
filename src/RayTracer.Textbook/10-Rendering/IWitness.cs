namespace RayTracer.Textbook;

/// <summary>Sees what becomes of the rays of a sample, for those who want to look inside (<see cref="Renderer.Follow"/>).</summary>
public interface IWitness
{
    /// <summary>The material in whose place another one stands, which takes note and scatters as it does.</summary>
    IMaterial Watch(IMaterial material);

    /// <summary>A ray has met something, or gone into the open.</summary>
    void Met(in Ray ray, in Hit hit, bool isHit);

    /// <summary>A path from a light begins.</summary>
    void Began();

    /// <summary>Where the last ray ended something shines: its radiance, and the share of it that counts.</summary>
    void Shone(Rgb radiance, double share);

    /// <summary>Where the last ray ended a light was asked: BSDF · cosine towards it, the share that counts, and what it adds, before the throughput.</summary>
    void Asked(ILight light, in LightSample sample, double chance, Rgb scattered, double share, Rgb added);

    /// <summary>Roulette let the path go on, with a probability.</summary>
    void Survived(double probability);
}
