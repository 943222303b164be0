using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Benchmarks;

/// <summary>
/// What everybody writes first: the report's recursion with one ray at a time, classes, virtual calls, doubles and
/// <see cref="Random"/>. The yardstick of the renderer's speed. It knows what the report scenes need (solid colours, all
/// shapes and materials, sphere lights sampled over the near half of their surface, as fast scalar code would).
/// </summary>
internal sealed class ScalarTracer
{
    private readonly SceneDescription _description;
    private readonly List<Surface> _surfaces = [];
    private readonly List<Ball> _lights = [];
    private readonly Vec _eye;
    private readonly Vec _forward;
    private readonly Vec _right;
    private readonly Vec _up;

    public ScalarTracer(SceneDescription description)
    {
        _description = description;
        foreach (ShapeDescription shape in description.Shapes.Concat(description.Lights))
        {
            Matter matter = Matter.From(shape.Material);
            Surface surface = shape switch
            {
                SphereDescription s => new Ball(matter, s.Center, s.Radius),
                PlaneDescription p => new Flat(matter, p.Normal, p.Point),
                TriangleDescription t => new Corner(matter, t.A, t.B, t.C),
                _ => throw new NotSupportedException(shape.GetType().Name),
            };
            _surfaces.Add(surface);
            if (surface is Ball { Matter: Lamp } lamp)
            {
                _lights.Add(lamp);
            }
        }

        CameraDescription camera = description.Camera;
        _eye = camera.Position;
        _forward = ((Vec)camera.LookAt - _eye).Unit();
        double scale = Math.Tan(camera.FieldOfView * Math.PI / 360);
        _right = Vec.Cross(_forward, camera.Up).Unit();
        _up = Vec.Cross(_right, _forward) * scale;
        _right *= scale * description.Render.Width / description.Render.Height;
    }

    public long Rays { get; private set; }

    /// <summary>Renders with n×n jittered samples and returns the mean of all pixels' green.</summary>
    public double Render()
    {
        RenderDescription render = _description.Render;
        int n = (int)Math.Round(Math.Sqrt(render.SamplesPerPixel));
        Random random = new(1);
        double total = 0;
        for (int y = 0; y < render.Height; y++)
        {
            for (int x = 0; x < render.Width; x++)
            {
                for (int i = 0; i < n * n; i++)
                {
                    double u = ((x + (((i % n) + random.NextDouble()) / n)) * 2 / render.Width) - 1;
                    double v = 1 - ((y + (((i / n) + random.NextDouble()) / n)) * 2 / render.Height);
                    total += Trace(new(_eye, (_forward + (_right * u) + (_up * v)).Unit()), 0, 0, true, random).Y;
                }
            }
        }

        return total / n / n / render.Width / render.Height;
    }

    private Vec Trace(Ray ray, int diffuseDepth, int specularDepth, bool countEmission, Random random)
    {
        Rays++;
        Hit hit = new();
        foreach (Surface surface in _surfaces)
        {
            surface.Intersect(ray, hit);
        }

        if (hit.Matter is not { } matter)
        {
            return Of(_description.Background);
        }

        Vec color = countEmission ? matter.Emitted(ray, hit) : default;
        color += matter.Ambient(ray, hit) * Of(_description.Ambient);
        if (matter.IsLit)
        {
            color += DirectLight(ray, hit, matter, random);
        }

        if (!matter.Scatter(ray, hit, random, out Vec direction, out Vec weight, out bool specular))
        {
            return color;
        }

        if (specular ? specularDepth >= _description.Render.MaxSpecularDepth : diffuseDepth >= _description.Render.MaxDiffuseDepth)
        {
            return color;
        }

        return color + (weight * Trace(
            new(hit.Point, direction), specular ? diffuseDepth : diffuseDepth + 1, specular ? specularDepth + 1 : specularDepth, specular, random));
    }

    private Vec DirectLight(Ray ray, Hit hit, Matter matter, Random random)
    {
        Vec normal = Facing(ray, hit);
        Vec brdf = matter.Brdf(-Vec.Dot(ray.Direction, normal));
        Vec sum = default;
        foreach (Ball light in _lights)
        {
            Vec onLight = OnSphere(random);
            Vec toCenter = light.Center - hit.Point;
            onLight = Vec.Dot(onLight, toCenter) > 0 ? -onLight : onLight;
            Vec to = toCenter + (onLight * light.Radius);
            double distance2 = Vec.Dot(to, to);
            double distance = Math.Sqrt(distance2);
            Vec direction = to * (1 / distance);
            double cosine = Vec.Dot(direction, normal);
            double cosineLight = -Vec.Dot(direction, onLight);
            if (cosine <= 0 || cosineLight <= 0)
            {
                continue;
            }

            Rays++;
            Ray shadow = new(hit.Point, direction);
            bool blocked = false;
            foreach (Surface surface in _surfaces)
            {
                if (surface.Blocks(shadow, distance * 0.9995))
                {
                    blocked = true;
                    break;
                }
            }

            if (!blocked)
            {
                var lamp = (Lamp)light.Matter;
                sum += lamp.Radiance(cosineLight) * brdf * (cosine * cosineLight * 2 * Math.PI * light.Radius * light.Radius / distance2);
            }
        }

        return sum;
    }

    private static Vec Of(Rgb c) => new(c.R, c.G, c.B);

    private static Vec Facing(Ray ray, Hit hit) => Vec.Dot(ray.Direction, hit.Normal) > 0 ? -hit.Normal : hit.Normal;

    private static Vec Mirror(Vec d, Vec n) => d - (n * (2 * Vec.Dot(d, n)));

    private static Vec OnSphere(Random random)
    {
        double z = 1 - (2 * random.NextDouble());
        double phi = 2 * Math.PI * random.NextDouble();
        double r = Math.Sqrt(1 - (z * z));
        return new(r * Math.Cos(phi), r * Math.Sin(phi), z);
    }

    private readonly record struct Vec(double X, double Y, double Z)
    {
        public static implicit operator Vec(Vector3 v) => new(v.X, v.Y, v.Z);

        public static Vec operator +(Vec a, Vec b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        public static Vec operator -(Vec a, Vec b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        public static Vec operator -(Vec a) => new(-a.X, -a.Y, -a.Z);

        public static Vec operator *(Vec a, Vec b) => new(a.X * b.X, a.Y * b.Y, a.Z * b.Z);

        public static Vec operator *(Vec a, double s) => new(a.X * s, a.Y * s, a.Z * s);

        public static double Dot(Vec a, Vec b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);

        public static Vec Cross(Vec a, Vec b) =>
            new((a.Y * b.Z) - (a.Z * b.Y), (a.Z * b.X) - (a.X * b.Z), (a.X * b.Y) - (a.Y * b.X));

        public Vec Unit() => this * (1 / Math.Sqrt(Dot(this, this)));
    }

    private sealed record Ray(Vec Origin, Vec Direction)
    {
        public Vec At(double t) => Origin + (Direction * t);
    }

    private sealed class Hit
    {
        public double Distance = double.PositiveInfinity;
        public Vec Point;
        public Vec Normal;
        public Matter? Matter;

        public void Set(double distance, Vec point, Vec normal, Matter matter)
        {
            Distance = distance;
            Point = point;
            Normal = normal;
            Matter = matter;
        }
    }

    private abstract class Surface(Matter matter)
    {
        protected const double Near = 1e-3;

        public Matter Matter => matter;

        public abstract void Intersect(Ray ray, Hit hit);

        public abstract bool Blocks(Ray ray, double distance);
    }

    private sealed class Ball(Matter matter, Vec center, double radius) : Surface(matter)
    {
        public Vec Center => center;

        public double Radius => radius;

        public override void Intersect(Ray ray, Hit hit)
        {
            double t = Solve(ray);
            if (t >= Near && t < hit.Distance)
            {
                Vec point = ray.At(t);
                hit.Set(t, point, (point - center) * (1 / radius), Matter);
            }
        }

        public override bool Blocks(Ray ray, double distance)
        {
            double t = Solve(ray);
            return t >= Near && t < distance;
        }

        private double Solve(Ray ray)
        {
            Vec from = ray.Origin - center;
            double b = Vec.Dot(from, ray.Direction);
            double discriminant = (b * b) - Vec.Dot(from, from) + (radius * radius);
            if (discriminant < 0)
            {
                return -1;
            }

            double root = Math.Sqrt(discriminant);
            double near = -b - root;
            return near < Near ? root - b : near;
        }
    }

    private sealed class Flat(Matter matter, Vec normal, Vec point) : Surface(matter)
    {
        private readonly Vec _normal = normal.Unit();
        private readonly double _d = Vec.Dot(normal.Unit(), point);

        public override void Intersect(Ray ray, Hit hit)
        {
            double t = Solve(ray);
            if (t > Near && t < hit.Distance)
            {
                hit.Set(t, ray.At(t), _normal, Matter);
            }
        }

        public override bool Blocks(Ray ray, double distance)
        {
            double t = Solve(ray);
            return t > Near && t < distance;
        }

        private double Solve(Ray ray) => (_d - Vec.Dot(_normal, ray.Origin)) / Vec.Dot(_normal, ray.Direction);
    }

    private sealed class Corner(Matter matter, Vec a, Vec b, Vec c) : Surface(matter)
    {
        private readonly Vec _ab = b - a;
        private readonly Vec _ac = c - a;
        private readonly Vec _normal = Vec.Cross(b - a, c - a).Unit();

        public override void Intersect(Ray ray, Hit hit)
        {
            if (Solve(ray, hit.Distance, out double t))
            {
                hit.Set(t, ray.At(t), _normal, Matter);
            }
        }

        public override bool Blocks(Ray ray, double distance) => Solve(ray, distance, out _);

        // Möller and Trumbore, 1997.
        private bool Solve(Ray ray, double limit, out double t)
        {
            t = 0;
            Vec p = Vec.Cross(ray.Direction, _ac);
            double inverse = 1 / Vec.Dot(_ab, p);
            Vec s = ray.Origin - a;
            double u = Vec.Dot(s, p) * inverse;
            if (u < 0 || u > 1)
            {
                return false;
            }

            Vec q = Vec.Cross(s, _ab);
            double v = Vec.Dot(ray.Direction, q) * inverse;
            if (v < 0 || u + v > 1)
            {
                return false;
            }

            t = Vec.Dot(_ac, q) * inverse;
            return t > Near && t < limit;
        }
    }

    private abstract class Matter
    {
        public virtual bool IsLit => false;

        public virtual Vec Emitted(Ray ray, Hit hit) => default;

        public virtual Vec Ambient(Ray ray, Hit hit) => default;

        public virtual Vec Brdf(double cosine) => default;

        public abstract bool Scatter(Ray ray, Hit hit, Random random, out Vec direction, out Vec weight, out bool specular);

        public static Matter From(MaterialDescription material) => material switch
        {
            DiffuseMaterialDescription d => new Matt(Solid(d.Color)),
            PhongMetalMaterialDescription m => new Metal(Solid(m.Color), m.Exponent),
            DielectricMaterialDescription g => new Glass(g.RefractiveIndex, Of(g.Extinction)),
            DiffuseSpecularMaterialDescription c => new Coated((Matt)From(c.Diffuse), From(c.Specular), c.R0),
            LuminaireMaterialDescription l => new Lamp(Solid(l.Color) * l.Multiplier, l.Exponent, From(l.Material)),
            _ => throw new NotSupportedException(material.GetType().Name),
        };

        // Pictures are stood in for by a colour: this tracer has no textures.
        private static Vec Solid(TextureDescription texture) => texture is SolidTextureDescription s ? Of(s.Color) : new(0.5, 0.5, 0.5);
    }

    private sealed class Matt(Vec color) : Matter
    {
        public override bool IsLit => true;

        public override Vec Ambient(Ray ray, Hit hit) => color;

        public override Vec Brdf(double cosine) => color * (1 / Math.PI);

        public override bool Scatter(Ray ray, Hit hit, Random random, out Vec direction, out Vec weight, out bool specular)
        {
            direction = (Facing(ray, hit) + (OnSphere(random) * 0.9999)).Unit();
            weight = color;
            specular = false;
            return true;
        }
    }

    private sealed class Metal(Vec color, double exponent) : Matter
    {
        public override Vec Ambient(Ray ray, Hit hit) => color;

        public override bool Scatter(Ray ray, Hit hit, Random random, out Vec direction, out Vec weight, out bool specular)
        {
            Vec r = Mirror(ray.Direction, hit.Normal);
            double cos = Math.Pow(random.NextDouble(), 1 / (exponent + 1));
            double sin = Math.Sqrt(1 - (cos * cos));
            double phi = 2 * Math.PI * random.NextDouble();
            Vec u = Vec.Cross(Math.Abs(r.X) > .5 ? new(0, 1, 0) : new(1, 0, 0), r).Unit();
            Vec v = Vec.Cross(r, u);
            direction = (u * (sin * Math.Cos(phi))) + (v * (sin * Math.Sin(phi))) + (r * cos);
            weight = color;
            specular = true;
            return Vec.Dot(direction, Facing(ray, hit)) > 0;
        }
    }

    private sealed class Glass(double index, Vec extinction) : Matter
    {
        public override bool Scatter(Ray ray, Hit hit, Random random, out Vec direction, out Vec weight, out bool specular)
        {
            bool inside = Vec.Dot(ray.Direction, hit.Normal) > 0;
            Vec n = Facing(ray, hit);
            double cos = -Vec.Dot(ray.Direction, n);
            double eta = inside ? index : 1 / index;
            double k = 1 - (eta * eta * (1 - (cos * cos)));
            double cosT = k > 0 ? Math.Sqrt(k) : 0;
            double r0 = Math.Pow((index - 1) / (index + 1), 2);
            double reflectance = k < 0 ? 1 : r0 + ((1 - r0) * Math.Pow(1 - (inside ? cosT : cos), 5));
            weight = inside
                ? new(Math.Exp(-extinction.X * hit.Distance), Math.Exp(-extinction.Y * hit.Distance), Math.Exp(-extinction.Z * hit.Distance))
                : new(1, 1, 1);
            direction = random.NextDouble() < reflectance
                ? Mirror(ray.Direction, n)
                : ((ray.Direction * eta) + (n * ((eta * cos) - cosT))).Unit();
            specular = true;
            return true;
        }
    }

    private sealed class Coated(Matt diffuse, Matter specularPart, double r0) : Matter
    {
        public override bool IsLit => true;

        public override Vec Ambient(Ray ray, Hit hit)
        {
            double reflectance = Reflectance(Math.Abs(Vec.Dot(ray.Direction, hit.Normal)));
            return (specularPart.Ambient(ray, hit) * reflectance) + (diffuse.Ambient(ray, hit) * (1 - reflectance));
        }

        public override Vec Brdf(double cosine) => diffuse.Brdf(cosine) * (1 - Reflectance(cosine));

        public override bool Scatter(Ray ray, Hit hit, Random random, out Vec direction, out Vec weight, out bool specular)
        {
            bool reflected = random.NextDouble() < Reflectance(Math.Abs(Vec.Dot(ray.Direction, hit.Normal)));
            return (reflected ? specularPart : diffuse).Scatter(ray, hit, random, out direction, out weight, out specular);
        }

        private double Reflectance(double cosine) => r0 + ((1 - r0) * Math.Pow(1 - cosine, 5));
    }

    private sealed class Lamp(Vec radiance, double exponent, Matter inner) : Matter
    {
        public override bool IsLit => inner.IsLit;

        public Vec Radiance(double cosine) => radiance * Math.Pow(Math.Max(0, cosine), exponent);

        public override Vec Emitted(Ray ray, Hit hit) => Vec.Dot(ray.Direction, hit.Normal) < 0 ? Radiance(-Vec.Dot(ray.Direction, hit.Normal)) : default;

        public override Vec Ambient(Ray ray, Hit hit) => inner.Ambient(ray, hit);

        public override Vec Brdf(double cosine) => inner.Brdf(cosine);

        public override bool Scatter(Ray ray, Hit hit, Random random, out Vec direction, out Vec weight, out bool specular) =>
            inner.Scatter(ray, hit, random, out direction, out weight, out specular);
    }
}
