using System.Text.Json;

namespace RayTracer.Cli.Tests;

public sealed class BenchAgainstTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public BenchAgainstTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [LinuxFact]
    public void A_build_has_the_time_and_the_bits_of_itself()
    {
        JsonElement json = Bench(AppContext.BaseDirectory, "--rounds", "4");
        JsonElement one = Assert.Single(json.GetProperty("scenes").EnumerateArray());
        Assert.Equal(4, json.GetProperty("rounds").GetInt32());
        Assert.True(one.GetProperty("hasSameBits").GetBoolean());
        Assert.Equal(1, one.GetProperty("noise").GetDouble());
        Assert.InRange(one.GetProperty("time").GetDouble(), one.GetProperty("timeLow").GetDouble(), one.GetProperty("timeHigh").GetDouble());
        Assert.InRange(one.GetProperty("time").GetDouble(), 0.5, 2);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public void A_build_that_traces_a_quarter_of_the_samples_has_four_times_the_noise()
    {
        // The same program, with a number of samples that replaces the one before it.
        Other($"exec '{ProcessTests.Program}' \"$@\" --spp 16");
        JsonElement one = Bench(_folder["other"], "--set", "render.sampler=independent", "--spp", "64", "--rounds", "8").GetProperty("scenes")[0];
        Assert.False(one.GetProperty("hasSameBits").GetBoolean());
        Assert.InRange(one.GetProperty("noise").GetDouble(), 0.15, 0.4);
        Assert.Equal(one.GetProperty("time").GetDouble() * one.GetProperty("noise").GetDouble(), one.GetProperty("timeToNoise").GetDouble(), 1e-12);
    }

    [LinuxFact]
    public void A_build_that_became_slower_is_found()
    {
        // The other build takes no time: its pictures are there already.
        for (int seed = 1; seed <= 6; seed++)
        {
            File.WriteAllText(_folder[$"{seed}.json"], CliRun.Fine("render", _scene, "--json", "--spp", "64", "--seed", $"{seed}", "-o", _folder[$"{seed}.pfm"]).Output);
        }

        Other($"while [ $# -gt 0 ]; do case $1 in --seed) seed=$2;; -o) file=$2;; esac; shift; done; cd '{_folder["."]}'; cp $seed.pfm \"$file\"; cat $seed.json");
        CliRun run = Alone("bench", _scene, "--against", _folder["other"], "--spp", "64", "--rounds", "6");
        Assert.Equal(ExitStatus.Different, run.Status);
        Assert.Contains("(same bits)", run.Output, StringComparison.Ordinal);
        Assert.Contains("of the time to the same noise", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void A_folder_without_a_command_is_named()
    {
        CliRun run = CliRun.Of("bench", _scene, "--against", _folder["none"]);
        Assert.Equal(ExitStatus.Usage, run.Status);
        Assert.Contains("--against: there is no command in this folder", run.Error, StringComparison.Ordinal);
        Assert.Contains("--rounds needs --against", CliRun.Of("bench", _scene, "--rounds", "3").Error, StringComparison.Ordinal);
    }

    // Binomial: P(rank of the median outside) is 0.0352 for 6 values between the smallest and the largest, 0.0352 for 15 between the 4th and the 12th.
    [Theory]
    [InlineData(2, 0, 1)]
    [InlineData(6, 0, 5)]
    [InlineData(15, 3, 11)]
    [InlineData(60, 21, 38)]
    public void The_interval_of_a_median_is_that_of_binomial_tables(int count, int low, int high) => Assert.Equal((low, high), BenchAgainst.RanksAroundMedian(count));

    // A script that stands for another build.
    private void Other(string script)
    {
        string program = Path.Combine(Directory.CreateDirectory(_folder["other"]).FullName, "raytracer");
        File.WriteAllText(program, $"#!/bin/sh\n{script}\n");
        if (!OperatingSystem.IsWindows())
        {
            File.SetUnixFileMode(program, UnixFileMode.UserRead | UnixFileMode.UserExecute);
        }
    }

    // As a process of its own: within this one, the children of other tests would be counted as its own.
    private static CliRun Alone(params string[] args)
    {
        (int status, string output, string error) = ProcessTests.Finish(ProcessTests.Start(args));
        return new(status, output, error);
    }

    private JsonElement Bench(string folder, params string[] more)
    {
        CliRun run = Alone(["bench", _scene, "--against", folder, "--json", .. more]);
        Assert.True(run.Status is ExitStatus.Fine or ExitStatus.Different, run.Error);
        return JsonDocument.Parse(run.Output).RootElement;
    }
}
