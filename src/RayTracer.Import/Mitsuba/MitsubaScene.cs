using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>Makes a scene of the things in a file.</summary>
internal sealed class MitsubaScene
{
    private readonly ImportReading _reading;
    private readonly MitsubaTextures _textures;
    private readonly MitsubaBsdfs _bsdfs;
    private readonly MitsubaEmitters _emitters;
    private readonly MitsubaShapes _shapes;

    public MitsubaScene(ImportReading reading)
    {
        _reading = reading;
        _textures = new(reading);
        _bsdfs = new(reading, _textures);
        _emitters = new(reading, _textures);
        _shapes = new(reading, _textures, _bsdfs, _emitters);
    }

    /// <summary>The scene that a file's outermost thing is.</summary>
    public SceneDescription Read(MitsubaObject root)
    {
        // What is referred to is read where it is; the names of all that stands by itself are kept.
        MitsubaObject[] bsdfs = [.. root.Children("bsdf")];
        MitsubaObject[] textures = [.. root.Children("texture")];
        MitsubaObject[] media = [.. root.Children("medium")];
        MitsubaObject[] phases = [.. root.Children("phase")];
        SceneDescription scene = new();
        scene = scene with { Render = scene.Render with { Sampler = SamplerKind.Independent, Integrator = Integrator.Path, ShadingNormals = ShadingNormals.Literal } };
        if (root.Only("integrator") is { } integrator)
        {
            scene = scene with { Render = MitsubaIntegrators.Read(integrator, scene.Render) };
        }

        _bsdfs.IsVolumetric = scene.Render.Integrator == Integrator.VolPath;
        scene = Sensor(root, scene);
        scene = Emitters(root, scene);
        ShapeDescription[] shapes = [.. root.Children("shape").Select(_shapes.Read).OfType<ShapeDescription>()];
        Array.ForEach(bsdfs, b => _ = _bsdfs.Read(b));
        Array.ForEach(textures, t => _ = _textures.Read(t));
        Array.ForEach(media, m => _ = MitsubaMedia.Read(m));
        Array.ForEach(phases, p => _ = MitsubaPhases.Read(p));
        root.Finish();
        return scene with { Shapes = shapes, Objects = _shapes.Groups, Materials = _bsdfs.Named, Textures = _textures.Named };
    }

    private SceneDescription Sensor(MitsubaObject root, SceneDescription scene)
    {
        MitsubaObject[] sensors = [.. root.Children("sensor")];
        if (sensors.Length == 0)
        {
            _reading.Log.Error(root.Place, "the scene has no sensor");
            return scene;
        }

        foreach (MitsubaObject other in sensors.Skip(1))
        {
            _reading.Log.Warn(other.Place, "the first sensor is used: this one is ignored");
        }

        return new MitsubaSensors(_reading).Read(sensors[0], scene);
    }

    private SceneDescription Emitters(MitsubaObject root, SceneDescription scene)
    {
        MitsubaObject[] all = [.. root.Children("emitter")];
        MitsubaObject[] around = [.. all.Where(MitsubaEmitters.IsEnvironment)];
        foreach (MitsubaObject second in around.Skip(1))
        {
            _reading.Log.Error(second.Place, "a scene may have only one emitter that surrounds it");
        }

        scene = around.Length > 0 ? _emitters.Environment(around[0], scene) : scene;
        return scene with { Lights = [.. all.Except(around).Select(_emitters.Punctual).OfType<ShapeDescription>()] };
    }
}
