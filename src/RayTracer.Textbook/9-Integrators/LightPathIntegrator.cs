namespace RayTracer.Textbook;

/// <summary>
/// Light tracing: paths from the lights, as light goes, each of whose points is joined with the camera (Dutré, Lafortune &amp; Willems 1993). It finds the bright
/// curves that glass makes, but of what is seen in mirrors only the lights: no path ends in a pinhole by chance.
/// </summary>
/// <param name="maxDepth">The largest number of edges of a path, that to the camera included; below 0 for no limit.</param>
/// <param name="rouletteDepth">The number of edges after which paths may end at random.</param>
public sealed class LightPathIntegrator(int maxDepth, int rouletteDepth) : ILightPathIntegrator
{
    /// <summary>What shines, as the camera sees it: all else comes from the lights.</summary>
    public Rgb Radiance(Scene scene, Ray ray, ISampler sampler) => MirrorPath.Radiance(scene, ray, sampler, maxDepth, rouletteDepth, (_, _, _) => default);

    /// <inheritdoc/>
    public void TraceLight(Scene scene, ISampler sampler, Action<double, double, Rgb> splat)
    {
        LightPath path = new(scene, sampler, rouletteDepth);
        while ((maxDepth < 0 || path.Edges + 2 <= maxDepth) && path.Next())
        {
            if (scene.Camera.Find(path.Hit.Point, sampler) is not { } sight)
            {
                continue;
            }

            Vector to = sight.Eye - path.Hit.Point;
            double distance = to.Length;
            Vector direction = to * (1 / distance);
            Rgb scattered = path.Scattered(direction);
            if (!scattered.IsBlack && scene.IsFree(path.Hit.Leave(direction), distance))
            {
                splat(sight.X, sight.Y, path.Power * scattered * sight.Density);
            }
        }
    }
}

/// <summary>A path that begins at a light.</summary>
/// <param name="scene">The scene.</param>
/// <param name="sampler">The source of random numbers.</param>
/// <param name="rouletteDepth">The number of edges after which it may end at random.</param>
internal sealed class LightPath(Scene scene, ISampler sampler, int rouletteDepth)
{
    private Ray _ray;
    private Vector _from;
    private Hit _hit;
    private Rgb _start;

    /// <summary>The number of edges so far.</summary>
    public int Edges { get; private set; }

    /// <summary>The surface that it has met last.</summary>
    public ref readonly Hit Hit => ref _hit;

    /// <summary>The power that it brings there.</summary>
    public Rgb Power { get; private set; }

    /// <summary>Where it came from, in the surface's frame.</summary>
    public Vector From => _from;

    /// <summary>Goes on to the next surface; false where the path ends.</summary>
    public bool Next()
    {
        if (!(Edges == 0 ? Begin() : Scatter()) || !scene.Intersect(_ray, out _hit))
        {
            return false;
        }

        Edges++;
        _from = _hit.Frame.ToLocal(-_ray.Direction);
        return true;
    }

    /// <summary>The share of its power, per steradian and times the cosine, that goes in a direction.</summary>
    public Rgb Scattered(Vector direction)
    {
        Vector to = _hit.Frame.ToLocal(direction);
        return _hit.Leaks(direction, to.Z) ? default
            : _hit.Thing!.Material.Evaluate(_hit, toViewer: to, toLight: _from) * (Math.Abs(to.Z) * Correction(direction, to));
    }

    private bool Begin()
    {
        if (scene.Lights.Count == 0)
        {
            return false;
        }

        (ILight light, double chance) = scene.ChooseLight(sampler.Next());
        if (light.Emit(sampler) is not { } emitted)
        {
            return false;
        }

        (_ray, Power) = (emitted.Ray, emitted.Power * (1 / chance));
        _start = Power;
        return !Power.IsBlack;
    }

    private bool Scatter()
    {
        if (_hit.Thing!.Material.Sample(_hit, _from, sampler) is not { } scattered)
        {
            return false;
        }

        Vector direction = _hit.Frame.ToWorld(scattered.Direction);
        Power *= scattered.Pdf > 0 ? Scattered(direction) * (1 / scattered.Pdf) : scattered.ParticleWeight;
        _ray = _hit.Leave(direction);

        // Roulette by the share of its first power that is left.
        Rgb left = new(Share(Power.R, _start.R), Share(Power.G, _start.G), Share(Power.B, _start.B));
        Rgb before = left;
        if (left.IsBlack || _hit.Leaks(direction, scattered.Direction.Z) || (Edges >= rouletteDepth && !PathIntegrator.Survives(scene, ref left, sampler.Next())))
        {
            return false;
        }

        Power *= left.Largest / before.Largest;
        return true;

        static double Share(double now, double first) => first > 0 ? now / first : 0;
    }

    // Interpolated normals make the areas across a surface another size for light than for viewers (Veach 1997, section 5.3.2).
    private double Correction(Vector direction, Vector to)
    {
        if (_hit.Shading == _hit.Normal)
        {
            return 1;
        }

        double comes = Math.Abs(_from.Z / Vector.Dot(_ray.Direction, _hit.Normal));
        return comes * Math.Abs(Vector.Dot(direction, _hit.Normal) / to.Z);
    }
}
