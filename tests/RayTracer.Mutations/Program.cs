// Applies small faults to the source, one by one, and reports which of them the tests catch. Takes an hour or so.
//
//     dotnet run -c Release --project tests/RayTracer.Mutations [-- WORD…]
//
// Works on a copy of the last commit; words choose mutants by parts of their area and name. The report goes to standard output
// as a Markdown table. The exit status is 0 if all were caught.
using System.Diagnostics;
using RayTracer.Mutations;

string root = AppContext.BaseDirectory;
while (!File.Exists(Path.Combine(root, "RayTracer.sln")))
{
    root = Path.GetDirectoryName(root) ?? throw new DirectoryNotFoundException("This must run within the repository.");
}

Mutant[] mutants = [.. Mutant.ReadAll(File.ReadLines(Path.Combine(root, "tests", "RayTracer.Mutations", "mutants.txt")))
    .Where(m => args.Length == 0 || args.Any(word => $"{m.Area}: {m.Name}".Contains(word, StringComparison.OrdinalIgnoreCase)))];
using Workshop workshop = new(root);

// Every mutant must apply before the first one is tried.
foreach (Mutant mutant in mutants)
{
    mutant.Apply(File.ReadAllText(workshop.PathOf(mutant.File)));
}

Console.WriteLine("| area | fault | caught by | seconds |\n|---|---|---|---|");
int caught = 0;
foreach (Mutant mutant in mutants)
{
    Stopwatch watch = Stopwatch.StartNew();
    IReadOnlyList<string> failing = Try(mutant);
    caught += failing.Count > 0 ? 1 : 0;
    string by = failing.Count == 0 ? "**not caught**" : $"{failing[0]}{(failing.Count > 1 ? $" and {failing.Count - 1} more" : "")}";
    Console.WriteLine($"| {mutant.Area} | {mutant.Name} | {by} | {watch.Elapsed.TotalSeconds:F0} |");
}

Console.WriteLine($"\n{caught} of {mutants.Length} caught");
return caught == mutants.Length ? 0 : 1;

IReadOnlyList<string> Try(Mutant mutant)
{
    // Committed hashes, and the check of the list of mutants, see that anything changed at all, which says little: they do not count.
    const string honest = "Category!=Pinned";
    string file = workshop.PathOf(mutant.File);
    string original = File.ReadAllText(file);
    try
    {
        File.WriteAllText(file, mutant.Apply(original));
        if (!workshop.Build(mutant.File))
        {
            return ["the compiler: this is no mutant"];
        }

        string suspects = string.Join('|', mutant.Suspects.Select(s => "FullyQualifiedName~" + s));
        string[] stages = [$"({suspects})&{honest}", $"Category!=Slow&{honest}", $"Category=Slow&{honest}"];
        return stages.Select(filter => workshop.FailingTests(filter, TimeSpan.FromMinutes(8))).FirstOrDefault(f => f.Count > 0, []);
    }
    finally
    {
        File.WriteAllText(file, original);
        workshop.Build(mutant.File);
    }
}
