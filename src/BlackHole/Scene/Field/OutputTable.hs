-- | The settings of sampling, of the film and of the files.
module BlackHole.Scene.Field.OutputTable
  ( outputFields,
  )
where

import BlackHole.Light.Display (Exposure (..), ToneMap (..), toneMapName)
import BlackHole.Light.Dither (Dither (..))
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Kind
import BlackHole.Scene.Field.Parts
import BlackHole.Scene.Filter (Filter (..), filterName)
import BlackHole.Scene.Scene
import Data.List (intercalate)

-- | The settings of sampling, of the film and of the files.
outputFields :: [Field]
outputFields =
  [ whole Sampling "sampling.samples" (1, 65536) ""
      `sets` part sceneSamples (\v s -> s {sceneSamples = v})
      `documented` "Rays of each pixel; with sampling.noise above 0 only the first ones, which \
                   \smooth places share"
      `withOption` ("samples", "N"),
    number Sampling "sampling.noise" (Quantity "a fraction of white" (From 0) (UpTo 1) "")
      `sets` part sceneNoise (\v s -> s {sceneNoise = v})
      `documented` "Standard error, as a fraction of display white, above which a pixel gets rays \
                   \of its own; below it, neighbours share their rays. With 0 no rays are shared \
                   \and none are added"
      `withOption` ("noise", "T"),
    whole Sampling "sampling.most-samples" (1, 65536) ""
      `sets` part sceneMostSamples (\v s -> s {sceneMostSamples = v})
      `documented` "Greatest number of rays that such a pixel gets"
      `withOption` ("most-samples", "N"),
    choice Sampling "sampling.filter" "a filter" filters
      `sets` part sceneFilter (\v s -> s {sceneFilter = v})
      `documented` "Reconstruction filter: box, gaussian or mitchell"
      `withOption` ("filter", "NAME"),
    seed Sampling "sampling.seed"
      `sets` part sceneSeed (\v s -> s {sceneSeed = v})
      `documented` "Seed of the random gas, stars and sampling, 0 to 2^64 - 1"
      `withOption` ("seed", "N"),
    number Output "output.exposure" (Quantity "a number of stops" (From (-100)) (UpTo 100) "")
      `sets` part (exposureStops . sceneExposure) (\v s -> s {sceneExposure = Exposure v})
      `documented` "Exposure in stops: +1 doubles the light, -1 halves it"
      `withOption` ("exposure", "STOPS"),
    choice Output "output.tone-map" "a tone map" toneMaps
      `sets` part sceneToneMap (\v s -> s {sceneToneMap = v})
      `documented` ( "Tone map, which compresses bright light into the range of a display: "
                       ++ intercalate ", " (map toneMapName [minBound ..])
                   )
      `withOption` ("tone-map", "NAME"),
    switch Output "output.dither"
      `sets` part
        ((== BlueNoise) . sceneDither)
        (\on s -> s {sceneDither = if on then BlueNoise else NoDither})
      `documented` "Whether to dither 8-bit files to prevent banding"
      `withOption` ("dither", "on|off"),
    number Output "output.beam" (Quantity "an angle" (From 0) (UpTo 90) "degrees")
      `sets` part sceneBeam (\v s -> s {sceneBeam = v})
      `documented` "Full width at half maximum, in degrees, of the Gaussian with which a radio \
                   \telescope blurs the picture; 0 for none"
      `withOption` ("beam", "DEGREES"),
    number Output "output.bloom" (Quantity "a fraction" (From 0) (UpTo 1) "of the light")
      `sets` part sceneBloom (\v s -> s {sceneBloom = v})
      `documented` "Fraction of the light that the lens scatters, 0 to 1"
      `withOption` ("bloom", "FRACTION"),
    whole Output "output.spikes" (0, 64) ""
      `sets` part sceneSpikes (\v s -> s {sceneSpikes = v})
      `documented` "Number of straight edges of the aperture that make diffraction spikes: an \
                   \even number makes as many spikes, an odd one twice as many; 0 for none"
      `withOption` ("spikes", "N"),
    number Output "output.spike-light" (Quantity "a fraction" (From 0) (UpTo 1) "of the light")
      `sets` part sceneSpikeLight (\v s -> s {sceneSpikeLight = v})
      `documented` "Fraction of the light in the spikes, 0 to 1",
    number
      Output
      "output.grain"
      (Quantity "a length" (From 0) (UpTo 100) "thousandths of the width")
      `sets` part sceneGrain (\v s -> s {sceneGrain = v})
      `documented` "Diameter of the dots of ink that make up the picture, in thousandths of its \
                   \width; 0 for continuous tones"
      `withOption` ("grain", "SIZE"),
    number Output "output.scale-bar" (Quantity "a length" (From 0) (UpTo 1e6) radii)
      `sets` part sceneScaleBar (\v s -> s {sceneScaleBar = v})
      `documented` "Length of a scale bar in the lower right corner, in Schwarzschild radii at \
                   \the distance of the hole; 0 for none"
      `withOption` ("scale-bar", "R"),
    switch Diagnostics "diagnostics.debug-textures"
      `sets` part sceneDebugTextures (\v s -> s {sceneDebugTextures = v})
      `documented` "Show checkerboards instead of the disk and the sky"
      `withFlag` ( "debug-textures",
                   SwitchValue True,
                   "Show checkerboards instead of the disk and the sky"
                 )
  ]
  where
    radii = "Schwarzschild radii"
    named name value meaning = (value, name value, meaning)
    filters =
      [ named filterName Box "the mean over the pixel's square",
        named filterName Gaussian "soft, of standard deviation 1/2 pixel",
        named filterName Mitchell "crisp, with negative lobes"
      ]
    toneMaps = [(tone, toneMapName tone, toneMapMeaning tone) | tone <- [minBound ..]]
    toneMapMeaning tone = case tone of
      ToneNone -> "none"
      ToneFilm -> "the soft shoulder of photographic film"
      ToneReinhard -> "low contrast"
      ToneAces -> "high contrast"
      ToneAgx -> "for very high dynamic range"
      ToneRadio -> "luminance as false colour, black to orange to white"
