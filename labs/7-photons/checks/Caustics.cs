using RayTracer.Labs;

namespace Lab7;

/// <summary>A picture of a scene, whose caustics are those of a photon map.</summary>
public static class Caustics
{
    private const int Samples = 9;
    private const int MostMirrors = 8;

    /// <summary>The light of a map at a place, towards the viewer.</summary>
    public delegate Rgb MapOf(in Hit hit, Vector toViewer);

    /// <summary>Renders it.</summary>
    public static Exhibit Picture(Scene scene, MapOf map, ISampler random)
    {
        Rgb[] pixels = new Rgb[Scenes.Width * Scenes.Height];
        for (int i = 0; i < pixels.Length * Samples; i++)
        {
            int pixel = i / Samples;
            Ray ray = scene.Camera.RayThrough((pixel % Scenes.Width) + random.Next(), (pixel / Scenes.Width) + random.Next(), random);
            pixels[pixel] += Radiance(scene, ray, map, random) * (1.0 / Samples);
        }

        return Pictures.Of("a glass ball, with the light of your photons below it", Scenes.Width, Scenes.Height, pixels);
    }

    private static Rgb Radiance(Scene scene, Ray ray, MapOf map, ISampler random)
    {
        Rgb throughput = Rgb.White;
        for (int mirrors = 0; mirrors <= MostMirrors && scene.Intersect(ray, out Hit hit); mirrors++)
        {
            Vector from = hit.Frame.ToLocal(-ray.Direction);
            if (hit.Thing!.Light is { } lamp)
            {
                return throughput * lamp.Radiance(ray.Direction, hit);
            }

            if (hit.Thing.Material.Sample(hit, from, random) is not { Lobe: Lobe.Mirror } mirror)
            {
                IMaterial material = hit.Thing.Material;
                Rgb direct = LightSampling.FromLight(scene, scene.Lights[0], hit, random, (in Hit at, Vector toLight) => material.Evaluate(at, from, toLight));
                return throughput * (direct + map(hit, from));
            }

            throughput *= mirror.Weight;
            ray = hit.Leave(hit.Frame.ToWorld(mirror.Direction));
        }

        return Rgb.Black;
    }
}
