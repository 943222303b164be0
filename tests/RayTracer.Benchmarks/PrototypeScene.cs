using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Benchmarks;

/// <summary>The scene "S2" on which the architecture was chosen: a floor, eight balls of all materials, a wall of two triangles, four lamps.</summary>
internal static class PrototypeScene
{
    public static SceneDescription Create(SamplerKind sampler, int samplesPerPixel)
    {
        MaterialDescription rust = Diffuse(.75f, .25f, .2f);
        MaterialDescription blue = Diffuse(.25f, .35f, .75f);
        List<ShapeDescription> shapes =
        [
            Ball(-1.2f, 1, -1.5f, 1, Glass(1.5f, new(.05f, .05f, .3f))),
            Ball(2.4f, .7f, -1.8f, .7f, Glass(1.33f, new(.4f, .05f, .05f))),
            Ball(1.1f, 1, .8f, 1, Metal(.9f, .85f, .6f, 2000)),
            Ball(-3, .9f, .5f, .9f, Metal(.8f, .8f, .85f, 60)),
            Ball(.6f, .5f, -2.6f, .5f, new DiffuseSpecularMaterialDescription { Diffuse = Diffuse(.2f, .5f, .25f), Specular = Metal(1, 1, 1, 100000), R0 = .06f }),
            Ball(-2.2f, .4f, -3, .4f, rust),
            Ball(3.4f, .9f, .6f, .9f, blue),
            Ball(-.9f, .8f, 2, .8f, rust),
            new PlaneDescription { Normal = new(0, 1, 0), Material = Diffuse(.7f, .7f, .65f) },
            new TriangleDescription { A = new(-3, 0, 4), B = new(3, 0, 4), C = new(3, 3, 4.5f), Material = blue },
            new TriangleDescription { A = new(-3, 0, 4), B = new(3, 3, 4.5f), C = new(-3, 3, 4.5f), Material = blue },
        ];
        Vector3[] lamps = [new(-4, 6, -3), new(4, 6, -3), new(-2, 7, 3), new(3, 7, 2)];
        for (int i = 0; i < lamps.Length; i++)
        {
            shapes.Add(new SphereDescription
            {
                Center = lamps[i],
                Radius = .3f,
                Material = new LuminaireMaterialDescription { Color = Color(70, 66, 60), Exponent = i < 2 ? 0 : 1 },
            });
        }

        return new SceneDescription
        {
            Camera = new() { Position = new(0, 3, -9), LookAt = new(0, .8f, 0), FieldOfView = 53.130102f },
            Render = new() { Integrator = Integrator.Report, SamplesPerPixel = samplesPerPixel, Sampler = sampler },
            Background = new(.5f, .7f, 1),
            Ambient = new(.1f, .1f, .1f),
            Shapes = shapes,
        };
    }

    private static SolidTextureDescription Color(float r, float g, float b) => new() { Color = new(r, g, b) };

    private static DiffuseMaterialDescription Diffuse(float r, float g, float b) => new() { Color = Color(r, g, b) };

    private static PhongMetalMaterialDescription Metal(float r, float g, float b, float exponent) => new() { Color = Color(r, g, b), Exponent = exponent };

    private static DielectricMaterialDescription Glass(float index, Rgb extinction) =>
        new() { RefractiveIndex = index, Extinction = extinction, Fresnel = FresnelModel.Schlick };

    private static SphereDescription Ball(float x, float y, float z, float radius, MaterialDescription material) =>
        new() { Center = new(x, y, z), Radius = radius, Material = material };
}
