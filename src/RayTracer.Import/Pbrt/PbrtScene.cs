using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Makes a scene of the things in a file.</summary>
internal sealed class PbrtScene(ImportReading reading, PbrtWorld world)
{
    /// <summary>The scene.</summary>
    public SceneDescription Read()
    {
        PbrtThing? camera = world.Only.GetValueOrDefault("camera");
        PbrtFilms films = new(world);
        float open = PbrtCameras.Exposure(camera);
        if (!(open > 0))
        {
            reading.Log.Error(camera!.Place, "the shutter must close after it opens");
        }

        SceneDescription scene = new();
        FilmRead film = films.Read(scene.Render with { ShadingNormals = ShadingNormals.Literal });
        float exposure = open * films.Sensitivity;
        PbrtLights lights = new(reading, exposure);
        PbrtTextures textures = new(reading, world);
        PbrtMaterials materials = new(reading, world, textures);
        PbrtMedia media = new(reading, world, exposure);
        PbrtShapes shapes = new(reading, world, textures, materials, media, lights);
        textures.ReadAll();
        materials.ReadAll();
        ShapeDescription[] seen = shapes.Read();
        media.ReadAll();
        return Lights(lights, scene) with
        {
            Camera = new PbrtCameras(reading).Read(camera, film),
            Render = camera is null ? film.Render : reading.At(camera.Place, film.Render),
            Shapes = seen,
            Objects = shapes.Objects,
            Materials = materials.Named,
            Textures = textures.Named,
        };
    }

    // Lights from all around add up.
    private SceneDescription Lights(PbrtLights lights, SceneDescription scene)
    {
        Rgb around = Rgb.Black;
        List<ShapeDescription> punctual = [];
        foreach (PbrtThing light in world.Lights)
        {
            if (light.Type == "infinite")
            {
                around += lights.Around(light);
            }
            else if (lights.Punctual(light) is { } made)
            {
                punctual.Add(made);
            }
        }

        return scene with { Background = around, Lights = punctual };
    }
}
