using System.Reflection;
using RayTracer.Mutations;

namespace RayTracer.Labs.Tests;

/// <summary>The solution, the starter and the mistakes of every lab, each with the checks in a namespace of its own: one run of the compiler makes them all.</summary>
internal sealed class LabVariants : IDisposable
{
    public const string Solution = "Solution";
    public const string Starter = "Starter";
    private static readonly TimeSpan s_patience = TimeSpan.FromMinutes(4);
    private readonly TemporaryFolder _folder = new();
    private readonly Assembly _assembly;

    public LabVariants()
    {
        List<string> files = [];
        foreach (Lab lab in Lab.All)
        {
            Dictionary<string, string> solution = Texts(lab, "solution");
            Dictionary<string, string> checks = Texts(lab, LabFolder.Checks);
            Add(lab, Solution, solution, checks);
            Add(lab, Starter, lab.Files("starter/").ToDictionary(f => f, lab.Text), checks);
            foreach ((Mutant mistake, int number) in Mistakes(lab).Select((m, i) => (m, i)))
            {
                string file = Path.GetFileName(mistake.File);
                Add(lab, NameOf(number), new(solution) { [file] = mistake.Apply(solution[file]) }, checks);
            }
        }

        string assembly = _folder["Labs.dll"];
        IReadOnlyList<string> errors = Compiler.Run(Compiler.Command(files, assembly), s_patience);
        Assert.True(errors.Count == 0, string.Join('\n', errors));
        _assembly = Assembly.Load(File.ReadAllBytes(assembly));

        void Add(Lab lab, string variant, Dictionary<string, string> sources, Dictionary<string, string> checks)
        {
            foreach ((string name, string text) in sources.Concat(checks.Select(c => KeyValuePair.Create($"checks-{c.Key}", c.Value))))
            {
                files.Add(_folder[$"{lab.Number}-{variant}-{name.Replace('/', '-')}"]);
                string space = $"namespace Lab{lab.Number};";
                Assert.Contains(space, text, StringComparison.Ordinal);
                File.WriteAllText(files[^1], text.Replace(space, $"namespace Lab{lab.Number}.{variant};", StringComparison.Ordinal));
            }
        }
    }

    /// <summary>The folder of a lab's sources.</summary>
    public static string FolderOf(Lab lab) => ProjectFolder.PathOf("labs", lab.Name);

    /// <summary>The common mistakes of a lab.</summary>
    public static IReadOnlyList<Mutant> Mistakes(Lab lab) => Mutant.ReadAll(File.ReadLines(Path.Combine(FolderOf(lab), "mistakes.txt")));

    /// <summary>The name of the variant with a mistake.</summary>
    public static string NameOf(int mistake) => $"Mistake{mistake}";

    /// <summary>Runs the checks of a variant, each as its finding is asked for.</summary>
    public IEnumerable<Finding> Check(Lab lab, string variant, string student) =>
        CheckHost.Checks(_assembly, $"Lab{lab.Number}.{variant}").Select(c => CheckHost.Run(c.Check, c.Method, student));

    private static Dictionary<string, string> Texts(Lab lab, string folder) =>
        Directory.GetFiles(Path.Combine(FolderOf(lab), folder)).ToDictionary(f => Path.GetFileName(f), f => File.ReadAllText(f).ReplaceLineEndings("\n"));

    public void Dispose() => _folder.Dispose();
}
