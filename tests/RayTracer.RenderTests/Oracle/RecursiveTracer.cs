using RayTracer.Textures;

namespace RayTracer.RenderTests.Oracle;

/// <summary>
/// The report's ray tracer as its chapter 6 prints it (listings 6.1 to 6.4), one ray after the other in double precision, with
/// its slips corrected: the branch of listing 6.3 is on the scatter's own flag, random numbers are always new ones, and the
/// eye is jittered around its place. It shares no code with the product, and is what the product is compared with.
/// </summary>
internal sealed class RecursiveTracer(Scene scene, RandomNumbers random)
{
    // Rays start on surfaces up to rounding, so that nearer hits are the surface itself.
    private const double Epsilon = 1e-7;

    /// <summary>Renders the picture with n×n jittered samples in each pixel (listing 6.1).</summary>
    public Picture Render(int n)
    {
        Picture picture = new(scene.Width, scene.Height);
        for (int y = 0; y < scene.Height; y++)
        {
            for (int x = 0; x < scene.Width; x++)
            {
                Vec color = Pixel(x, y, n);
                int at = 3 * ((y * scene.Width) + x);
                (picture.Pixels[at], picture.Pixels[at + 1], picture.Pixels[at + 2]) = ((float)color.X, (float)color.Y, (float)color.Z);
            }
        }

        return picture;
    }

    private Vec Pixel(int x, int y, int n)
    {
        Vec color = default;
        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j < n; j++)
            {
                (Vec origin, Vec direction) = scene.Camera.Ray(
                    x + ((i + random.Next()) / n), y + ((j + random.Next()) / n), scene.Width, scene.Height, random);
                color += Color(origin, direction, 0, 0, countEmittedLight: true);
            }
        }

        return color / (n * n);
    }

    // Listing 6.3.
    private Vec Color(Vec origin, Vec direction, int diffuseDepth, int specularDepth, bool countEmittedLight)
    {
        if (Intersect(origin, direction) is not { } record)
        {
            return scene.Background;
        }

        Vec color = scene.Ambient * record.Material.AmbientResponse(record);
        if (countEmittedLight)
        {
            color += record.Material.EmittedRadiance(-Vec.Dot(direction, record.Normal), record.Shape, record.Point);
        }

        if (record.Material.DiffuseDirection(record, random) is not { } scatter || scatter.Color == default)
        {
            return color;
        }

        if (scatter.Specular)
        {
            return specularDepth < scene.MaxSpecularDepth
                ? color + (scatter.Color * Color(record.Point, scatter.Direction, diffuseDepth, specularDepth + 1, countEmittedLight: true))
                : color;
        }

        color += DirectLight(record);
        return diffuseDepth < scene.MaxDiffuseDepth
            ? color + (scatter.Color * Color(record.Point, scatter.Direction, diffuseDepth + 1, specularDepth, countEmittedLight: false))
            : color;
    }

    // Listing 6.4.
    private Vec DirectLight(HitRecord record)
    {
        Vec result = default;
        foreach (Shape light in scene.Lights)
        {
            (Vec onLight, double area) = light.RandomPoint(record.Point, random);
            Vec toLight = onLight - record.Point;
            double distance = toLight.Length;
            double cosine0 = Vec.Dot(toLight, record.Facing) / distance;
            double cosine1 = -Vec.Dot(toLight, light.Normal(onLight)) / distance;
            if (area > 0 && cosine0 > 0 && cosine1 > 0 && !ShadowHit(record.Point, toLight, light))
            {
                Vec emitted = light.Material.EmittedRadiance(cosine1, light, onLight);
                result += area * cosine0 * cosine1 / (distance * distance) * record.Material.ExplicitBrdf(record) * emitted;
            }
        }

        return result;
    }

    private bool ShadowHit(Vec origin, Vec toLight, Shape light)
    {
        foreach (Shape shape in scene.Shapes)
        {
            // The light itself is met at the end, if it is not met before.
            double end = shape == light ? 1 - 1e-6 : 1;
            if ((shape != light || light.MayHideItself) && !double.IsNaN(shape.Hit(origin, toLight, Epsilon, end)))
            {
                return true;
            }
        }

        return false;
    }

    private HitRecord? Intersect(Vec origin, Vec direction)
    {
        double nearest = double.PositiveInfinity;
        Shape? met = null;
        foreach (Shape shape in scene.Shapes)
        {
            double t = shape.Hit(origin, direction, Epsilon, nearest);
            if (!double.IsNaN(t))
            {
                nearest = t;
                met = shape;
            }
        }

        return met is null ? null : new(met, origin + (nearest * direction), direction, nearest);
    }
}
