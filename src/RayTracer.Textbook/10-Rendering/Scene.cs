namespace RayTracer.Textbook;

/// <summary>A thing in a scene: a shape, and what it is made of.</summary>
/// <param name="Shape">The shape.</param>
/// <param name="Material">How it scatters light.</param>
/// <param name="Light">The light that it is; null where it does not shine.</param>
/// <param name="Source">What it was made from; null where that is not known.</param>
public sealed record Thing(IShape Shape, IMaterial Material, AreaLight? Light = null, object? Source = null);

/// <summary>All that rays can meet, and what lights it.</summary>
public sealed class Scene
{
    private Thing[] _things;
    private readonly int _bounded;
    private readonly IAccelerator _tree;
    private readonly Distribution _choice;
    private readonly Dictionary<ILight, double> _chances = [];

    /// <summary>Makes one.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="things">The things.</param>
    /// <param name="points">Lights without extent.</param>
    /// <param name="environment">What surrounds it; null for darkness.</param>
    /// <param name="ambient">Ambient light (report, section 4.2): what every surface gets besides.</param>
    /// <param name="tree">Makes the tree of some shapes; null for <see cref="BoundingVolumes"/>.</param>
    public Scene(
        ICamera camera, IEnumerable<Thing> things, IEnumerable<ILight> points, IEnvironment? environment, Rgb ambient,
        Func<IReadOnlyList<IShape>, IAccelerator>? tree = null)
    {
        (Camera, Ambient) = (camera, ambient);

        // Planes without end fit into no tree: they come last, and are asked one by one.
        _things = [.. things.OrderBy(t => t.Shape.Bounds.IsFinite ? 0 : 1)];
        IShape[] bounded = [.. _things.Select(t => t.Shape).Where(s => s.Bounds.IsFinite)];
        _bounded = bounded.Length;
        _tree = (tree ?? (shapes => new BoundingVolumes(shapes)))(bounded);
        Bounds = Array.ConvertAll(bounded, s => s.Bounds).Aggregate(Bounds.Empty, (all, box) => all.With(box));
        Environment = environment is null ? null : new(environment, bounded.Length > 0 ? Bounds : new(default, default));
        Lights = [.. _things.Select(t => t.Light).OfType<ILight>(), .. points, .. Environment is null ? Array.Empty<ILight>() : [Environment]];
        _choice = new([.. Lights.Select(l => l.Power)]);
        for (int i = 0; i < Lights.Count; i++)
        {
            _chances.Add(Lights[i], _choice.Probability(i));
        }
    }

    /// <summary>The camera.</summary>
    public ICamera Camera { get; }

    /// <summary>The things; those without end come last.</summary>
    public IReadOnlyList<Thing> Things => _things;

    /// <summary>Sees what becomes of rays; null where nobody looks.</summary>
    public IWitness? Witness { get; private set; }

    /// <summary>All sources of light.</summary>
    public IReadOnlyList<ILight> Lights { get; }

    /// <summary>The light that surrounds it; null for darkness.</summary>
    public EnvironmentLight? Environment { get; }

    /// <summary>Ambient light.</summary>
    public Rgb Ambient { get; }

    /// <summary>A box around all things that have an end.</summary>
    public Bounds Bounds { get; }

    /// <summary>True where something has no end.</summary>
    public bool IsEndless => _bounded < _things.Length;

    /// <summary>The same scene, with somebody who looks.</summary>
    public Scene WatchedBy(IWitness witness)
    {
        Scene watched = (Scene)MemberwiseClone();
        (watched.Witness, watched._things) = (witness, Array.ConvertAll(_things, t => t with { Material = witness.Watch(t.Material) }));
        return watched;
    }

    /// <summary>Finds what a ray meets first.</summary>
    /// <param name="ray">The ray, with a unit direction.</param>
    /// <param name="hit">What it meets.</param>
    /// <returns>False where it goes into the open.</returns>
    public bool Intersect(in Ray ray, out Hit hit)
    {
        hit = Hit.None();
        bool isHit = Find(ray, ref hit);
        if (isHit)
        {
            hit.Thing = _things[hit.Index];
            hit.Thing.Shape.Describe(ray, ref hit);
            hit.Face(ray.Direction);
        }

        Witness?.Met(ray, hit, isHit);
        return isHit;
    }

    /// <summary>True where nothing stands between a ray's origin and a distance (the report's shadow ray, section 4.3.1).</summary>
    public bool IsFree(in Ray ray, double distance)
    {
        Hit hit = Hit.None(distance * (1 - 1e-6));
        return !Find(ray, ref hit);
    }

    /// <summary>Chooses one of the lights, in proportion to their power.</summary>
    /// <param name="random">A random number from 0 to 1.</param>
    public (ILight Light, double Chance) ChooseLight(double random)
    {
        int chosen = _choice.Choose(random).Chosen;
        return (Lights[chosen], _choice.Probability(chosen));
    }

    /// <summary>The probability with which <see cref="ChooseLight"/> chooses a light.</summary>
    public double Chance(ILight light) => _chances[light];

    private bool Find(in Ray ray, ref Hit hit)
    {
        bool isHit = _tree.Intersect(ray, ref hit);
        for (int i = _bounded; i < _things.Length; i++)
        {
            if (_things[i].Shape.Intersect(ray, ref hit))
            {
                hit.Index = i;
                isHit = true;
            }
        }

        return isHit;
    }
}
