using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
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
        Vector2 shutter = PbrtCameras.Shutter(camera);
        float open = shutter.Y - shutter.X;
        if (!(open > 0))
        {
            reading.Log.Error(camera!.Place, "the shutter must close after it opens");
        }

        SceneDescription scene = new();
        bool moves = camera?.State.Places.Moves == true || world.Shapes.Concat(world.Objects.Values.SelectMany(o => o)).Any(s => s.State.Places.Moves);
        FilmRead film = films.Read(scene.Render with { ShadingNormals = ShadingNormals.Literal, Shutter = moves ? shutter : scene.Render.Shutter });
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
        ImageEnvironmentDescription? picture = null;
        List<ShapeDescription> punctual = [];
        foreach (PbrtThing light in world.Lights)
        {
            if (light.Type == "infinite" && light.Has("filename"))
            {
                if (picture is not null)
                {
                    reading.Log.Unsupported(light.Place, "a scene has one picture of its surroundings", "the last one is shown");
                }

                picture = lights.Surroundings(light);
            }
            else if (light.Type == "infinite")
            {
                around += lights.Around(light);
            }
            else if (lights.Punctual(light) is { } made)
            {
                punctual.Add(made);
            }
        }

        if (picture is not null && !around.IsBlack)
        {
            reading.Log.Unsupported(world.Lights.First(l => l.Type == "infinite" && !l.Has("filename")).Place, "light from all around is either a picture or a colour", "the picture alone is shown");
            around = Rgb.Black;
        }

        return scene with { Background = around, Environment = picture, Lights = punctual };
    }
}
