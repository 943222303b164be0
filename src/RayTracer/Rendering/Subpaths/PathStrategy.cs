namespace RayTracer.Rendering;

/// <summary>A way to make paths of some length: how many vertices come from a light, and how many from the camera (Veach 1997, section 10.2).</summary>
/// <param name="Light">The light subpath's vertices, that on the light included.</param>
/// <param name="Camera">The camera subpath's vertices, that on the lens included.</param>
/// <param name="IsMerge">True where the last vertices of both are taken for one; else an edge joins them.</param>
internal readonly record struct PathStrategy(int Light, int Camera, bool IsMerge)
{
    /// <summary>The number of edges of its paths.</summary>
    public int Edges => Light + Camera - (IsMerge ? 2 : 1);

    /// <summary>The name of its layer.</summary>
    public string Name => $"{(IsMerge ? "merge." : "")}s{Light}t{Camera}";

    /// <summary>Lists what an integrator has of them.</summary>
    /// <param name="strategies">The ways that it knows.</param>
    /// <param name="most">The most edges.</param>
    public static IEnumerable<PathStrategy> Of(Strategies strategies, int most)
    {
        // Photons that come straight from a light are left to those who ask it.
        int firstMerged = (strategies & Strategies.Camera) != Strategies.None ? 2 : 3;
        for (int edges = 1; edges <= most; edges++)
        {
            for (int light = 0; light <= edges; light++)
            {
                PathStrategy connected = new(light, edges + 1 - light, false);
                if ((strategies & connected.Kind) != Strategies.None)
                {
                    yield return connected;
                }
            }

            for (int light = firstMerged; light <= edges && (strategies & Strategies.Merges) != Strategies.None; light++)
            {
                yield return new(light, edges + 2 - light, true);
            }
        }
    }

    // A light that is connected with the lens would be one that is seen straight, which camera paths meet.
    private Strategies Kind => (Light, Camera) switch
    {
        (0, _) => Strategies.Seen,
        (1, 1) => Strategies.None,
        (1, _) => Strategies.Lights,
        (_, 1) => Strategies.Camera,
        _ => Strategies.Connections,
    };
}
