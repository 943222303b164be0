using OwnMaterial;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Import;
using RayTracer.Rendering;
using RayTracer.Scenes;

// A scene file that names a material of this program, and a model.
Plugins.Add(typeof(Velvet).Assembly);
Importers.Register();

string path = Path.Combine(AppContext.BaseDirectory, "scene.json");
SceneLoadResult result = SceneLoader.Load(args.Length > 1 ? args[1] : path);
foreach (Diagnostic diagnostic in result.Diagnostics)
{
    Console.Error.WriteLine(diagnostic);
}

if (result.Scene is not { } scene)
{
    return 1;
}

(Film film, _) = new RTracer(scene).Render();
ImageFile.Write(args.Length > 0 ? args[0] : "velvet.png", film);
Console.WriteLine($"film {film.ComputeHash()}");
return 0;
