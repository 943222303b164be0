using RayTracer.Textbook;

namespace RayTracer.Session;

/// <summary>Takes note of what becomes of the rays of a sample in the textbook edition: a tree of vertices, as glass may send two rays on.</summary>
/// <param name="ambient">The scene's ambient light.</param>
/// <param name="weighsPart">True where the integrator weighs a path by the chosen part of a material; else by all parts.</param>
internal sealed class RayNotes(Textbook.Rgb ambient, bool weighsPart) : IWitness
{
    // Directions and places that differ by rounding only are the same.
    private const double Rounding = 1e-7;

    /// <summary>The vertices, in the order in which rays met them.</summary>
    public List<Vertex> Vertices { get; } = [];

    /// <inheritdoc/>
    public IMaterial Watch(IMaterial material) => new Watched(material, this);

    /// <inheritdoc/>
    public void Met(in Textbook.Ray ray, in Textbook.Hit hit, bool isHit)
    {
        Vertex vertex = new(ray, hit, isHit);
        for (int i = Vertices.Count - 1; i >= 0 && vertex.Before is null; i--)
        {
            Vertex before = Vertices[i];
            Vector direction = ray.Direction;
            bool starts = before.IsHit && (ray.Origin - before.Hit.Point).Length < Rounding * (before.Hit.Point.Largest + before.Hit.Distance + 1);
            if (starts && before.Offered.FirstOrDefault(o => (o.Direction - direction).Length < Rounding) is { } way)
            {
                (vertex.Before, vertex.Came) = (before, way);
                vertex.Throughput = before.Throughput * way.Weight * (1 / before.Survival);
            }
        }

        Vertices.Add(vertex);
    }

    /// <inheritdoc/>
    public void Began() => Vertices.Clear();

    /// <inheritdoc/>
    public void Shone(Textbook.Rgb radiance, double share) => (Vertices[^1].Radiance, Vertices[^1].Share) = (radiance, share);

    /// <inheritdoc/>
    public void Asked(ILight light, in LightSample sample, double chance, Textbook.Rgb scattered, double share, Textbook.Rgb added) =>
        Vertices[^1].Lights.Add(new(light, sample, chance, scattered, share, added));

    /// <inheritdoc/>
    public void Survived(double probability) => Vertices[^1].Survival = probability;

    /// <summary>A place where a ray ended.</summary>
    internal sealed class Vertex(Textbook.Ray ray, Textbook.Hit hit, bool isHit)
    {
        /// <summary>The ray that came here.</summary>
        public Textbook.Ray Ray => ray;

        /// <summary>What it met.</summary>
        public Textbook.Hit Hit => hit;

        /// <summary>False where it went into the open.</summary>
        public bool IsHit => isHit;

        /// <summary>The vertex from which the ray came; null for the camera.</summary>
        public Vertex? Before { get; set; }

        /// <summary>The factor on light from here.</summary>
        public Textbook.Rgb Throughput { get; set; } = Textbook.Rgb.White;

        /// <summary>The probability with which roulette let the path go on.</summary>
        public double Survival { get; set; } = 1;

        /// <summary>The radiance of what shines here.</summary>
        public Textbook.Rgb Radiance { get; set; }

        /// <summary>The share of it that counts.</summary>
        public double Share { get; set; }

        /// <summary>Ambient light that is reflected.</summary>
        public Textbook.Rgb Ambient { get; set; }

        /// <summary>The directions that the material chose.</summary>
        public List<Way> Offered { get; } = [];

        /// <summary>The one of those of the vertex before in which the ray came; null for the camera's.</summary>
        public Way? Came { get; set; }

        /// <summary>The lights that were asked.</summary>
        public List<AskedLight> Lights { get; } = [];

        /// <summary>The light that was found here, before the throughput.</summary>
        public Textbook.Rgb Direct => Lights.Aggregate(default(Textbook.Rgb), (sum, l) => sum + l.Added);

        /// <summary>All light that is added here.</summary>
        public Textbook.Rgb Contribution => Throughput * ((Radiance * Share) + Ambient + Direct);
    }

    /// <summary>A direction that a material chose, with BSDF · cosine / pdf.</summary>
    internal sealed record Way(Vector Direction, Textbook.Rgb Weight, double Pdf, Textbook.Rgb? Bsdf, double Cosine, Lobe Lobe);

    /// <summary>A light that was asked.</summary>
    internal sealed record AskedLight(ILight Light, LightSample Sample, double Chance, Textbook.Rgb Scattered, double Share, Textbook.Rgb Added);

    private sealed class Watched(IMaterial inner, RayNotes notes) : IMaterial
    {
        public Textbook.Rgb Evaluate(in Textbook.Hit hit, Vector toViewer, Vector toLight) => inner.Evaluate(hit, toViewer, toLight);

        public double Pdf(in Textbook.Hit hit, Vector from, Vector to) => inner.Pdf(hit, from, to);

        public Scattering? Sample(in Textbook.Hit hit, Vector from, ISampler sampler)
        {
            Scattering? chosen = inner.Sample(hit, from, sampler);
            if (chosen is { } s)
            {
                Offer(hit, from, s);
            }

            return chosen;
        }

        public IReadOnlyList<Scattering> Mirrors(in Textbook.Hit hit, Vector from)
        {
            IReadOnlyList<Scattering> mirrors = inner.Mirrors(hit, from);
            foreach (Scattering s in mirrors)
            {
                Offer(hit, from, s);
            }

            return mirrors;
        }

        public Textbook.Rgb Matt(in Textbook.Hit hit, Vector toViewer) => inner.Matt(hit, toViewer);

        public Textbook.Rgb Ambient(in Textbook.Hit hit, Vector toViewer)
        {
            Textbook.Rgb share = inner.Ambient(hit, toViewer);
            notes.Vertices[^1].Ambient = notes.Ambience * share;
            return share;
        }

        private void Offer(in Textbook.Hit hit, Vector from, in Scattering s)
        {
            double cosine = Math.Abs(s.Direction.Z);
            bool isChoice = s.Pdf > 0 && !notes.WeighsPart;
            Textbook.Rgb bsdf = isChoice ? inner.Evaluate(hit, from, s.Direction) : default;
            notes.Vertices[^1].Offered.Add(new(hit.Frame.ToWorld(s.Direction), isChoice ? bsdf * (cosine / s.Pdf) : s.Weight, s.Pdf, isChoice ? bsdf : null, cosine, s.Lobe));
        }
    }

    private Textbook.Rgb Ambience => ambient;

    private bool WeighsPart => weighsPart;
}
